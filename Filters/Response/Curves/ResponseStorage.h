// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResponseStorage_h
#define ResponseStorage_h

#include "Laws/ResponseFiller.h"

#include "palpateResponseModule.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace palpate
{
/// The point arrays of one response. They are allocated and attached together.
struct PALPATERESPONSE_EXPORT ResponseStorage
{
  vtkNew<vtkFloatArray> Force;
  vtkNew<vtkFloatArray> Stiffness;
  vtkNew<vtkFloatArray> Normal;
  vtkNew<vtkFloatArray> Range;
  vtkNew<vtkFloatArray> Validity;
  vtkNew<vtkUnsignedCharArray> Status;
  vtkNew<vtkUnsignedCharArray> LimitReached;

  vtkSmartPointer<vtkFloatArray> Error; ///< null if the errors are not stored

  ResponseStorage(const std::string& name, vtkIdType points, int samples, bool keepsError);
  /// `normals` has 3 numbers per point, and `status` one number per point (fillPointNormals).
  void setNormals(const std::vector<float>& normals, const std::vector<unsigned char>& status);
  ResponseSpans spans();
  void attach(vtkPolyData* output);
};
} // namespace palpate

#endif
