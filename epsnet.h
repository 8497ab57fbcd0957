#pragma once

/// All of epsnet that is made for programs of others: surfaces, nets, certificates, closed geodesics, pictures, files.
///
/// A program that only checks files needs certify/check.h, certify/geodesics/geodesics_check.h and
/// certify/file/reader.h and is linked with the library `epsnet_certify` alone.

#include "certify/check.h"
#include "certify/document/document.h"
#include "certify/document/geodesics_document.h"
#include "certify/document/interval.h"
#include "certify/document/report.h"
#include "certify/file/reader.h"
#include "certify/file/writer.h"
#include "certify/geodesics/geodesics_check.h"
#include "kernel/complex.h"
#include "kernel/isometry.h"
#include "kernel/numbers.h"
#include "netgen/base/length.h"
#include "netgen/exchange/domain_format.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/imported_net.h"
#include "netgen/exchange/mesh_export.h"
#include "netgen/exchange/triangulation_stream.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/lifts/lifts.h"
#include "netgen/lifts/net_geometry.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/net_options.h"
#include "netgen/pictures/curves.h"
#include "netgen/pictures/draw.h"
#include "netgen/pictures/viewer.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/octagon.h"
#include "netgen/surfaces/pants_graph.h"
#include "netgen/surfaces/surface_file.h"
#include "triangulation/error.h"
#include "triangulation/surface.h"
#include "triangulation/triangulation.h"
