// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyData_h
#define palpate_BodyData_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace palpate
{
/// The content of a file with a body or a scan, as stored in the file.
struct BodyData
{
  vtkSmartPointer<vtkDataSet> data; ///< null after an error
  std::vector<std::string> notes;   ///< changes to the content; each note is part of a sentence
  std::string fault;                ///< error message without the name of the file; "": no error
};

/// Reads a file. Its name determines the kind; see vtkBodyFileReader. Never throws or crashes, for
/// any content. Replaces VTK's output window while it runs, so call it from one thread only.
BodyData readBodyData(const std::string& path);

/// The file name extensions that can be read, ".vtp .stl ...".
std::string bodyFileExtensions();
} // namespace palpate

#endif
