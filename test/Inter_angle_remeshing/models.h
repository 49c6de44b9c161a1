// Copyright (c) 2026 The Inter_angle_remeshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTER_ANGLE_REMESHING_TEST_MODELS_H
#define CGAL_INTER_ANGLE_REMESHING_TEST_MODELS_H

// Models from files, and what CGAL's algorithms make of models.

#include "invariants.h"
#include "meshes.h"

#include <cstddef>
#include <string>

namespace models {

using namespace invariants;

// The one of this name in CGAL's folder, as `elephant`. Throws where it cannot be read.
Mesh of_cgal(const std::string& name);

// The triangles of a file, polygons cut into them: where faces meet that no manifold has, the surface is cut. Empty where the file
// has no faces that can be triangulated.
Mesh from_file(const std::string& path);

// Sewn at points with equal coordinates, its triangles turned to agree.
Mesh from_soup(const meshes::Soup& soup);

// What is below the plane of this closed mesh, closed by the plane. Throws where that fails, as the next one does.
Mesh cut_off(Mesh mesh, const Kernel::Plane_3& plane);

// What of `a` is not in `b`; both closed.
Mesh difference(Mesh a, Mesh b);

// The mesh with about so many faces, by CGAL's edge collapses of Lindstrom and Turk.
Mesh simplified(Mesh mesh, std::size_t faces);

// The alpha wrap at 1/30 of the diagonal of the bounding box, offset by 1/600 of it.
Mesh wrap(const Mesh& mesh);

// The result of CGAL::Polygon_mesh_processing::isotropic_remeshing().
Mesh remeshed_by_pmp(Mesh mesh, double length, unsigned iterations = 10);

} // namespace models

#endif // CGAL_INTER_ANGLE_REMESHING_TEST_MODELS_H
