// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_BodyData_h
#define palpate_BodyData_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace palpate
{
/// The content of a file of a body or a scan, as it is in the file.
struct BodyData
{
  vtkSmartPointer<vtkDataSet> data; ///< null after an error
  std::vector<std::string> notes;   ///< what was done to the content, a part of a sentence each
  std::string fault;                ///< without the name of the file; "": nothing is wrong
};

/// Reads a file, of the kind that its name says; see vtkBodyFileReader. Never throws or crashes,
/// whatever is in it. VTK's output window is replaced meanwhile, so call it from one thread only.
BodyData readBodyData(const std::string& path);

/// The ends of the names of files that are read, ".vtp .stl ...".
std::string bodyFileExtensions();
} // namespace palpate

#endif
