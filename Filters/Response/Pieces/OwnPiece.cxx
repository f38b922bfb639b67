// SPDX-License-Identifier: BSD-3-Clause
#include "Response/Pieces/OwnPiece.h"

#include "Response/Pieces/Ranks.h"

#include "vtkCleanPolyData.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace palpate
{
vtkSmartPointer<vtkPolyData> ownPiece(vtkPolyData* input, const Ranks& ranks)
{
  if (input && ranks.areAlone())
  {
    return input;
  }
  auto piece = vtkSmartPointer<vtkPolyData>::New();
  if (input)
  {
    piece->ShallowCopy(input);
    if (input->HasAnyGhostCells())
    {
      piece->RemoveGhostCells();
      vtkNew<vtkCleanPolyData> unused; // removes points that belonged only to ghost cells
      unused->PointMergingOff();
      unused->ConvertLinesToPointsOff();
      unused->ConvertPolysToLinesOff();
      unused->ConvertStripsToPolysOff();
      unused->SetInputData(piece);
      unused->Update();
      piece->ShallowCopy(unused->GetOutput());
    }
  }
  if (!piece->GetPoints())
  {
    piece->SetPoints(vtkNew<vtkPoints>());
  }
  return piece;
}

std::string checkType(vtkInformation* input, const char* what)
{
  vtkDataObject* given = input ? vtkDataObject::GetData(input) : nullptr;
  if (!given || vtkPolyData::SafeDownCast(given))
  {
    return {};
  }
  return std::string("the ") + what + " must be vtkPolyData, but is " + given->GetClassName() +
    "; Body Surface (vtkBodySurface) makes one surface of it (in ParaView: Tool Contact Response "
    "takes it as it "
    "is)";
}
} // namespace palpate
