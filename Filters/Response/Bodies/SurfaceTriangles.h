// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * One data set, whole or in partitions, as triangles.
 *
 * A surface of triangles alone comes out unchanged if it is sound. Polygons and strips are cut,
 * vertices and lines left out. Of a volume the outer faces are taken. Partitions are joined where
 * their points coincide exactly, and ghost cells are left out.
 */
#ifndef SurfaceTriangles_h
#define SurfaceTriangles_h

#include "Response/Bodies/SoundBody.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace palpate
{
struct SurfaceTriangles
{
  vtkSmartPointer<vtkPolyData> surface; // null after a fault
  bool isOfVolume = false;
  std::vector<std::string> notes; // what was done, each part of a sentence
  std::string loss;               // which input is not used, for a warning; "" if all is
  std::string fault;              // why there are none; "" if there are
  bool isEmpty = false;           // the fault is only that there are none
};

/// The surface, still with polygons and strips. `wholeExtent`: that of all ranks' pieces of a
/// structured grid, of which only the faces are surface; null: the grid is whole. Pieces must have
/// points.
SurfaceTriangles extractSurface(const std::vector<vtkDataSet*>& pieces, const int* wholeExtent);

/// Cuts it into triangles, and orients them (SoundMesh); a fault if there are none, or no body.
void cutSurface(
  SurfaceTriangles& made, const std::vector<vtkDataSet*>& pieces, SoundBody::Extent extent);

/// Names of point arrays that some of the data sets have and others lack, comma-separated: those
/// lost by appending.
std::string arraysNotShared(const std::vector<vtkDataSet*>& pieces);
} // namespace palpate

#endif
