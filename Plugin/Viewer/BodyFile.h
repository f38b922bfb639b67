// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads the body of the command line from a file of any supported kind, as a surface for contact.
 *
 * .palpate is a body with its response in mm, as written by --export. .vtp .stl .ply .obj .vtk are
 * surfaces, and .vtu .vtk volume meshes; vtkBodySurface converts them. .vti .vtk .nii .nii.gz are
 * scans; vtkSkinSurface finds their outer skin. If a base value is given, the skin has the array
 * LayerThickness (mm), see vtkLayerThickness.
 *
 * The body is in millimetres. A NIfTI scan is positioned by its header. A valid .vtp or .vtk of
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
  double lengthScale = 1.0;  // mm per unit of length of the file
  double resolution = 0.0;   // for a scan: resolution of the skin, mm; 0: the scan's own resolution
  double contourValue = 0.0; // for a scan: grey level of the skin; 0: chosen from the scan
  double closingRadius = 6.0;      // for a scan: openings up to twice this size are closed, mm
  std::optional<double> baseValue; // for a scan: grey level below which it is bone
};

struct BodyFileResult
{
  vtkSmartPointer<vtkPolyData> body; // triangles only; null after an error
  std::vector<std::string> notes;    // changes to the content of the file, one sentence each
  std::string error;                 // an error that names the file; "" on success
};

/// Reads `path`. Never throws. Messages of the readers go into the error, not to the console: VTK's
/// output window is replaced during the call, so call this from one thread only.
BodyFileResult readBodyFile(const std::string& path, const BodyFileOptions& options);
} // namespace palpate

#endif
