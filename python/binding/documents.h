#pragma once

#include <memory>
#include <string>

#include "certify/net/document.h"
#include "certify/verdict/report.h"
#include "netgen/pictures/net_pictures.h"
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

/// How a check is done: of what was made here, or of a file, which may take only the work that one of its size may.
[[nodiscard]] inline certify::CheckOptions check_options(unsigned threads, bool own, const Progress& progress) {
  if (own) return own_check(threads, progress);
  certify::CheckOptions options;
  options.threads = threads;
  options.progress = progress;
  return options;
}

/// What all documents have: their check, their text, the file.
///
/// `check(document, options)` and `write(document, stream)` are those of the kind.
template <class Document, class Class, class Check, class Write, class Parse>
void bind_document(Class& bound, const Check& check, const Write& write, const Parse& parse) {
  bound
      .def(
          "check",
          [check](const Shared<Document>& self, unsigned threads, bool unlimited, const py::object& callback) {
            const auto checked = [self, check, threads, unlimited](const Progress& progress) {
              return check(*self, check_options(threads, unlimited, progress));
            };
            return interruptible(checked, callback);
          },
          py::arg("threads") = 0, py::arg("unlimited") = false, py::arg("progress") = py::none())
      .def(
          "save",
          [write](const Shared<Document>& self, const std::filesystem::path& path) {
            save(path, [self, write](std::ostream& out) { write(*self, out); });
          },
          py::arg("path"))
      .def("text",
           [write](const Shared<Document>& self) {
             return py::bytes(
                 interruptible([self, write] { return written([&](std::ostream& out) { write(*self, out); }); }));
           })
      .def_static(
          "parse",
          [parse](const std::string& text, const std::string& name) {
            return interruptible([=] { return Shared<Document>(parse(text, name)); });
          },
          py::arg("text"), py::arg("name"))
      .def("__eq__", [](const Shared<Document>& a, const Shared<Document>& b) {
        return interruptible([=] { return *a == *b; });
      });
}

}  // namespace epsnet::python
