// SPDX-License-Identifier: BSD-3-Clause
#ifndef BandTable_h
#define BandTable_h

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkTable.h"

namespace palpate
{
/// Three columns that are filled again and again: what lies between the second and the third is
/// drawn as an area (addBand). Nothing is drawn where there are no rows.
class BandTable
{
public:
  BandTable(const char* x, const char* least, const char* most)
  {
    this->X->SetName(x);
    this->Least->SetName(least);
    this->Most->SetName(most);
    for (vtkDoubleArray* column : { this->X.Get(), this->Least.Get(), this->Most.Get() })
    {
      this->Table->AddColumn(column);
    }
    this->begin();
    this->end();
  }

  void begin()
  {
    for (vtkDoubleArray* column : { this->X.Get(), this->Least.Get(), this->Most.Get() })
    {
      column->SetNumberOfValues(0);
    }
  }
  void add(double x, double least, double most)
  {
    this->X->InsertNextValue(x);
    this->Least->InsertNextValue(least);
    this->Most->InsertNextValue(most);
  }
  /// An area needs two rows.
  void end()
  {
    while (this->X->GetNumberOfValues() < 2)
    {
      this->add(0.0, 0.0, 0.0);
    }
    for (vtkDoubleArray* column : { this->X.Get(), this->Least.Get(), this->Most.Get() })
    {
      column->Modified();
    }
    this->Table->Modified();
  }

  vtkTable* table() { return this->Table; }

private:
  vtkNew<vtkTable> Table;
  vtkNew<vtkDoubleArray> X;
  vtkNew<vtkDoubleArray> Least;
  vtkNew<vtkDoubleArray> Most;
};
} // namespace palpate

#endif
