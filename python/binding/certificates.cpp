#include "certify/base/interval.h"
#include "certify/verdict/report.h"
#include "python/binding/binding.h"

namespace epsnet::python {
namespace {

using certify::Certificate;

py::dict counts_of(const Certificate& certificate) {
  const certify::Counts& counts = certificate.counts;
  py::dict result;
  result["vertices"] = counts.vertices;
  result["edges"] = counts.edges;
  result["triangles"] = counts.triangles;
  result["genus"] = counts.genus;
  result["tiles"] = counts.tiles;
  result["charts"] = counts.charts;
  result["labels"] = counts.labels;
  result["label_identities"] = counts.label_identities;
  result["exact_ties"] = counts.exact_ties;
  result["triangles_beyond_64_bits"] = counts.triangles_beyond_64_bits;
  result["max_precision_used"] = counts.max_precision_used;
  result["work"] = counts.work;
  if (counts.collars) result["collars"] = *counts.collars;
  if (const auto& geodesics = certificate.geodesics) {
    result["geodesics"] = geodesics->geodesics;
    result["lifted_triangles"] = geodesics->lifted_triangles;
    result["candidates"] = geodesics->candidates;
    result["deep_vertices"] = geodesics->deep_vertices;
  }
  return result;
}

py::dict enclosures_of(const Certificate& certificate) {
  py::dict result;
  if (!certificate.enclosures) return result;
  const certify::Enclosures& enclosures = *certificate.enclosures;
  result["epsilon"] = enclosures.epsilon;
  result["area"] = enclosures.area;
  result["largest_circumradius"] = enclosures.largest_circumradius;
  result["longest_edge"] = enclosures.longest_edge;
  if (enclosures.shortest_edge) result["shortest_edge"] = *enclosures.shortest_edge;
  if (enclosures.shortest_loop) result["shortest_loop"] = *enclosures.shortest_loop;
  if (enclosures.shortest_core) result["shortest_core"] = *enclosures.shortest_core;
  return result;
}

}  // namespace

void bind_certificates(py::module_& module) {
  py::class_<Certificate>(module, "Certificate")
      .def_property_readonly("verdict", [](const Certificate& c) { return certify::name(c.verdict); })
      .def_readonly("claim", &Certificate::claim)
      .def_readonly("rule", &Certificate::rule)
      .def_readonly("message", &Certificate::message)
      .def_property_readonly("rules",
                             [](const Certificate& c) {
                               std::vector<std::tuple<std::string, std::string, std::string>> rules;
                               for (const certify::RuleReport& report : c.rules) {
                                 rules.emplace_back(report.rule, certify::name(report.verdict), report.text);
                               }
                               return rules;
                             })
      .def_readonly("ties", &Certificate::ties)
      .def_property_readonly("counts", &counts_of)
      .def_property_readonly("enclosures", &enclosures_of)
      .def_property_readonly("line", [](const Certificate& c) { return certify::verdict_line(c); });
  module.def("decimal_below", py::overload_cast<double>(&certify::decimal_below));
  module.def("decimal_above", py::overload_cast<double>(&certify::decimal_above));
}

}  // namespace epsnet::python
