// SPDX-License-Identifier: BSD-3-Clause
/** @file
 * Between vtkPolyData with responses and the flat body file that loops without VTK read.
 */
#ifndef FlatBodyConversion_h
#define FlatBodyConversion_h

#include "palpateResponseModule.h" // For export macro

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkPolyData;

namespace palpate
{
/// Writes triangles and the response with prefix `name` as a FlatBodyFile. Returns an error naming
/// the array or the file, or "".
PALPATERESPONSE_EXPORT std::string writeFlatBody(
  vtkPolyData* body, const std::string& name, const std::string& path);

/// Reads such a file as a body with the response under prefix `name`: the same bits as were
/// written. Null and an error naming the file if it cannot be used.
PALPATERESPONSE_EXPORT vtkSmartPointer<vtkPolyData> readFlatBody(
  const std::string& path, const std::string& name, std::string& error);
} // namespace palpate

#endif
