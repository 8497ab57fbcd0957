#pragma once

#include <string>
#include <vector>

#include "netgen/base/json_text.h"
#include "netgen/base/options.h"

/// What can be asked of the module, in any language: a request is a JSON object and files, and so is its answer.
///
/// Nothing is kept from one request to the next: surfaces and nets are the texts of their files. So whoever stops a
/// computation by ending its process loses nothing but the answer.
namespace epsnet::wasm {

/// A request, docs/wasm.md.
struct Request {
  Json what;                       ///< The member "do" names the request; numbers of files stand for files.
  std::vector<std::string> files;  ///< Their bytes.
};

/// Its answer.
struct Answer {
  std::string json;                     ///< An object.
  std::vector<std::string> files = {};  ///< Their bytes; the request says which.
};

/// Returns the answer to a request. If there is none, it is {"error": {"kind": …, "message": …}}, where the kind is the
/// name of a class of the Python module's errors, or "MemoryError". Never throws but for want of memory twice.
[[nodiscard]] Answer answer(const Request& request, const Progress& progress);

}  // namespace epsnet::wasm
