#include "python/binding/binding.h"

PYBIND11_MODULE(_epsnet, module) {
  module.doc() = "The C++ library behind the package epsnet, under names of its own: use the package.";
  module.attr("__version__") = EPSNET_VERSION;
  epsnet::python::bind_errors(module);
  epsnet::python::bind_numbers(module);
  epsnet::python::bind_surfaces(module);
  epsnet::python::bind_certificates(module);
  epsnet::python::bind_nets(module);
  epsnet::python::bind_geodesics(module);
  epsnet::python::bind_isometries(module);
  epsnet::python::bind_pants(module);
  epsnet::python::bind_distances(module);
  epsnet::python::bind_eigenvalues(module);
  epsnet::python::bind_files(module);
}
