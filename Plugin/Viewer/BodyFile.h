// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads the body of the command line, of any kind, as a surface to be touched.
 *
 * .palpate: a body with its response, as written by --export; in mm already. .vtp .stl .ply .obj
 * .vtk: surfaces; .vtu .vtk: volume meshes. For their conversion see vtkBodySurface. .vti .vtk .nii
 * .nii.gz: scans. Their outer skin is taken, see vtkSkinSurface; if a base value is given, with the
 * array LayerThickness (mm), see vtkLayerThickness.
 *
 * The body is in millimetres, a NIfTI scan where its header puts it. A sound .vtp or .vtk of
 * triangles is unchanged, with all its arrays.
 */
#ifndef palpate_BodyFile_h
#define palpate_BodyFile_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
struct BodyFileOptions
{
  double lengthScale = 1.0;        // mm per unit of length of the file
  double resolution = 0.0;         // of a scan, mm; 0 = its own
  double contourValue = 30.0;      // of a scan: grey level of the skin
  double closingRadius = 6.0;      // of a scan, mm: openings of up to twice this are closed
  std::optional<double> baseValue; // of a scan: grey level below which it is bone
};

struct BodyFileResult
{
  vtkSmartPointer<vtkPolyData> body; // triangles only; null after an error
  std::vector<std::string> notes;    // what was done to the file's content, one sentence each
  std::string error;                 // names the file; "" on success
};

/// Reads `path`. Never throws. The readers' messages go into the error, not to the console: VTK's
/// output window is replaced meanwhile, so call it from one thread only.
BodyFileResult readBodyFile(const std::string& path, const BodyFileOptions& options);
} // namespace palpate

#endif
