// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResponseFiller_h
#define ResponseFiller_h

#include "CurvatureBound.h"
#include "ResponseLaw.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <string>

class vtkPolyData;

namespace palpate
{
class AxisymmetricTool;

/// The point arrays of one response, allocated together, attached together.
struct ResponseStorage
{
  vtkNew<vtkFloatArray> Force;
  vtkNew<vtkFloatArray> Stiffness;
  vtkNew<vtkFloatArray> Normal;
  vtkNew<vtkFloatArray> Range;
  vtkNew<vtkFloatArray> Validity;
  vtkNew<vtkUnsignedCharArray> Status;
  vtkNew<vtkUnsignedCharArray> LimitReached;

  ResponseStorage(const std::string& name, vtkIdType points, int samples);
  void attach(vtkPolyData* output);
};

/// The stiffness of the body at each point.
struct ResponseMaterial
{
  double constantModulus = 0.0;           ///< E*, MPa
  const double* reducedModulus = nullptr; ///< per point; null: the constant
  const double* compliance = nullptr;     ///< mm/N per point; null: none
};

/**
 * Fills the storage of a response point by point: the curve of a law, and how deep it may be
 * trusted (vtkToolContactResponse.h, Validity). The normals and the status of the storage must be
 * set. fill may run on disjoint ranges at the same time.
 */
class ResponseFiller
{
public:
  ResponseFiller(const AxisymmetricTool& tool, const ResponseLaw& law,
    const CurvatureBound& curvature, const ResponseMaterial& material, double range,
    ResponseStorage& storage);

  void fill(vtkIdType first, vtkIdType last) const;

private:
  unsigned char fillCurve(vtkIdType i, double curvature, double modulus, double compliance) const;
  void fillValidity(vtkIdType i, double curvature, double modulus, double compliance) const;

  const AxisymmetricTool& Tool;
  const ResponseLaw& Law;
  const CurvatureBound& Curvature;
  ResponseMaterial Material;
  double StrainDepth;
  float Range;
  // The storage.
  int Samples;
  float* Force;
  float* Stiffness;
  float* RangeOf;
  float* Validity;
  unsigned char* Status;
  unsigned char* LimitReached;
};
} // namespace palpate

#endif
