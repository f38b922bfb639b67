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
 * Returns the piece of a body on this rank. With one rank, this is the input itself. With several
 * ranks, it is the input without ghost cells. Without input the piece has no points. Never returns
 * null.
 */
PALPATERESPONSE_EXPORT vtkSmartPointer<vtkPolyData> ownPiece(
  vtkPolyData* input, const Ranks& ranks);

/// Checks that an input is vtkPolyData. Returns "" or an error that names the filter that converts
/// the input. `what` is the name of the input in the error, "body" or "tips".
PALPATERESPONSE_EXPORT std::string checkType(vtkInformation* input, const char* what);
} // namespace palpate

#endif
