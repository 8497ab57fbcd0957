#include <variant>

#include "certify/check.h"
#include "certify/file/reader.h"
#include "netgen/base/options.h"
#include "python/binding/documents.h"

namespace epsnet::python {
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
