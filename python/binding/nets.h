#pragma once

#include "certify/document/document.h"
#include "python/binding/documents.h"

namespace epsnet::python {

using SharedNet = Shared<certify::NetDocument>;

}  // namespace epsnet::python
