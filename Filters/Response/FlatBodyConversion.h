// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Conversion between vtkPolyData with responses and the flat body file. Servo loops without VTK can
 * read the flat body file.
 */
#ifndef FlatBodyConversion_h
#define FlatBodyConversion_h

#include "palpateResponseModule.h" // For export macro

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkPolyData;

namespace palpate
{
/// Writes the triangles and the response with the prefix `name` to the flat body file `path`.
/// Returns "" or an error that names the array or the file.
PALPATERESPONSE_EXPORT std::string writeFlatBody(
  vtkPolyData* body, const std::string& name, const std::string& path);

/// Reads a flat body file. Returns a body that has the response with the prefix `name`. All numbers
/// are bitwise equal to the written numbers. If the file is not valid, returns null and an error
/// that names the file.
PALPATERESPONSE_EXPORT vtkSmartPointer<vtkPolyData> readFlatBody(
  const std::string& path, const std::string& name, std::string& error);
} // namespace palpate

#endif
