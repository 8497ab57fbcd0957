#include "python/binding/documents.h"

#include <variant>

#include "certify/base/interval.h"
#include "certify/check.h"
#include "certify/file/reader.h"
#include "certify/verdict/report.h"
#include "netgen/base/options.h"
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

namespace {

/// The contents of a file that can be checked, as the class of its kind.
py::object claim_of(certify::ClaimDocument claim) {
  return std::visit([]<class Document>(Document& document) { return py::cast(Shared<Document>(std::move(document))); },
                    claim);
}

}  // namespace

void bind_files(py::module_& module) {
  module.def("display_name", &certify::display_name, py::arg("path"));
  module.def(
      "read",
      [](const std::filesystem::path& path) {
        return py::bytes(interruptible([path] { return certify::load(path); }));
      },
      py::arg("path"));
  module.def(
      "parse_claim",
      [](const std::string& text, const std::string& name) {
        return claim_of(interruptible([=] { return certify::parse_file<certify::ClaimDocument>(text, name); }));
      },
      py::arg("text"), py::arg("name"));
  module.def(
      "length_text", [](double length) { return Length(length).text(); }, py::arg("length"));
  module.def(
      "length_text", [](const std::string& length) { return Length(length).text(); }, py::arg("length"));
  module.def(
      "write_text",
      [](const std::string& text, const std::filesystem::path& path) {
        save(path, [text](std::ostream& out) { out << text; });
      },
      py::arg("text"), py::arg("path"));
}

}  // namespace epsnet::python
