// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeshFileCheck_h
#define palpate_MeshFileCheck_h

#include <string>

namespace palpate
{
/// Why a .stl or .ply file is unfit for VTK's readers, or "": of a truncated binary .stl they
/// return the existing part; a damaged .ply makes them crash. Reads the file once; other extensions
/// are not checked.
std::string meshFileProblem(const std::string& path, const std::string& extension);
} // namespace palpate

#endif
