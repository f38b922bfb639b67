// SPDX-License-Identifier: BSD-3-Clause
#ifndef palpate_ReplacedCurves_h
#define palpate_ReplacedCurves_h

#include <string>
#include <vector>

class vtkPolyData;

/// What filters share that put another form of a response in place of the one there was.
namespace palpate
{
/// The same data, with a list of field arrays of its own.
void copyWithOwnFields(vtkPolyData* from, vtkPolyData* to);
/// Takes the curves of a response away, in whichever form; the rest of it stays.
void removeCurves(vtkPolyData* body, const std::string& name);
/// Attaches values where the contract places the array, in place of one of the same name.
void addFloats(vtkPolyData* body, const std::string& name, ResponseArray which, int components,
  const std::vector<float>& values);
/// A text as a field array, in place of one of the same name.
void addText(vtkPolyData* body, const std::string& name, const std::string& text);
} // namespace palpate

#endif
