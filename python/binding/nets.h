#pragma once

#include "certify/net/document.h"
#include "python/binding/documents.h"

namespace epsnet::python {

using SharedNet = Shared<certify::NetDocument>;

}  // namespace epsnet::python
