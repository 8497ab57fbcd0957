#pragma once

/// The public interface of epsnet: surfaces, nets, certificates, closed geodesics, pictures, files.
///
/// A program that only checks files includes certify/check.h and certify/file/file.h, and links the library
/// `epsnet_certify` alone.

#include "certify/check.h"
#include "certify/documents.h"
#include "certify/file/file.h"
#include "certify/net/document.h"
#include "certify/verdict/report.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "netgen/base/options.h"
#include "netgen/curves/curves.h"
#include "netgen/distances/distances.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/exchange/exchange.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "netgen/pants/pants.h"
#include "netgen/pictures/pictures.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/surface/surface.h"
