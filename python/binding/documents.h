#pragma once

#include <memory>
#include <string>
#include <utility>

#include "certify/check.h"
#include "certify/file/reader.h"
#include "certify/file/writer.h"
#include "certify/net/document.h"
#include "certify/verdict/report.h"
#include "netgen/pictures/pictures.h"
#include "netgen/prove/certified.h"
#include "python/binding/binding.h"
#include "python/binding/job.h"

namespace epsnet::python {

/// The contents of a file as Python holds them: never changed, so that arrays and pictures may refer to them.
template <class Document>
struct Shared {
  std::shared_ptr<const Document> document;

  explicit Shared(Document contents) : document(std::make_shared<const Document>(std::move(contents))) {}
  const Document& operator*() const { return *document; }
  const Document* operator->() const { return document.get(); }
};

/// A proved document as Python holds it, with its certificate.
template <class Document>
[[nodiscard]] std::pair<Shared<Document>, certify::Certificate> shared(Certified<Document> found) {
  return {Shared<Document>(std::move(found.document)), std::move(found.certificate)};
}

/// What all documents have: their check, as of a file that somebody else made, their text, the file.
template <class Document, class Class>
void bind_document(Class& bound) {
  bound
      .def(
          "check",
          [](const Shared<Document>& self, unsigned threads, const py::object& callback) {
            const auto checked = [self, threads](const Progress& progress) {
              return certify::check(*self, {.threads = threads, .progress = progress});
            };
            return interruptible(checked, callback);
          },
          py::arg("threads") = 0, py::arg("progress") = py::none())
      .def(
          "save",
          [](const Shared<Document>& self, const std::filesystem::path& path) {
            save(path, [self](std::ostream& out) { certify::write_file(*self, out); });
          },
          py::arg("path"))
      .def("text",
           [](const Shared<Document>& self) {
             return py::bytes(interruptible(
                 [self] { return written([&](std::ostream& out) { certify::write_file(*self, out); }); }));
           })
      .def_static(
          "parse",
          [](const std::string& text, const std::string& name) {
            return interruptible([=] { return Shared<Document>(certify::parse_file<Document>(text, name)); });
          },
          py::arg("text"), py::arg("name"))
      .def("__eq__", [](const Shared<Document>& a, const Shared<Document>& b) {
        return interruptible([=] { return *a == *b; });
      });
}

using SharedNet = Shared<certify::NetDocument>;

}  // namespace epsnet::python
