// SPDX-License-Identifier: BSD-3-Clause
#ifndef OwnPiece_h
#define OwnPiece_h

#include "palpateResponseModule.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkInformation;
class vtkPolyData;

namespace palpate
{
class Ranks;

/**
 * The piece of a body that this rank has: the input itself where there is one rank; otherwise the
 * input without ghost cells, or a piece without points if there is none. Never null.
 */
PALPATERESPONSE_EXPORT vtkSmartPointer<vtkPolyData> ownPiece(
  vtkPolyData* input, const Ranks& ranks);

/// What is wrong with the type of an input that should be vtkPolyData, naming the filter that
/// converts it, or "". `what` is its name in the text: "body" or "tips".
PALPATERESPONSE_EXPORT std::string checkType(vtkInformation* input, const char* what);
} // namespace palpate

#endif
