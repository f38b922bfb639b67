// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyData_h
#define palpate_BodyData_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace palpate
{
/// The content of a file with a body or a scan, with the values that the file stores.
struct BodyData
{
  vtkSmartPointer<vtkDataSet> data; ///< content of the file; null after an error
  std::vector<std::string> notes;   ///< changes to the content; each note is part of a sentence
  /// Error message without the name of the file; "" if there is no error.
  std::string fault;
};

/// Reads a file. The end of the file name determines the format; see vtkBodyFileReader. Never
/// throws an exception and never crashes, for any content. Replaces VTK's output window during the
/// call; therefore call it from one thread only.
BodyData readBodyData(const std::string& path);

/// Returns the file name extensions that can be read, as the text ".vtp .stl ...".
std::string bodyFileExtensions();
} // namespace palpate

#endif
