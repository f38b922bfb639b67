// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_MeshFileCheck_h
#define palpate_MeshFileCheck_h

#include <string>

namespace palpate
{
/// What makes a .stl or .ply file unfit for VTK's readers, "" if nothing: of a binary .stl cut
/// short they return the part that is there; a damaged .ply makes them crash. Reads the file once;
/// other extensions are not looked at.
std::string meshFileProblem(const std::string& path, const std::string& extension);
} // namespace palpate

#endif
