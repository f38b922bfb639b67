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

/// The body under each point: constants, and arrays that override them where they are not null.
struct ResponseMaterial
{
  ContactSpot constant;
  const double* reducedModulus = nullptr; ///< MPa
  const double* poissonsRatio = nullptr;
  const double* compliance = nullptr; ///< mm/N
  const double* thickness = nullptr;  ///< mm, 0 for a half-space

  ContactSpot at(vtkIdType i) const
  {
    const auto pick = [i](const double* array, double otherwise)
    { return array ? array[i] : otherwise; };
    return { pick(this->reducedModulus, this->constant.reducedModulus),
      pick(this->poissonsRatio, this->constant.poissonsRatio),
      pick(this->compliance, this->constant.compliance),
      pick(this->thickness, this->constant.thickness) };
  }
};

/**
 * Fills the storage of a response point by point: the curve of a law, and how deep it may be
 * trusted (vtkToolContactResponse.h, Validity). The normals and the status of the storage must be
 * set. `bodyWidth` (mm) is that of the whole body. fill may run on disjoint ranges at the same
 * time.
 */
class ResponseFiller
{
public:
  ResponseFiller(const AxisymmetricTool& tool, const ResponseLaw& law,
    const CurvatureBound& curvature, const ResponseMaterial& material, double range,
    double bodyWidth, ResponseStorage& storage);

  void fill(vtkIdType first, vtkIdType last) const;

private:
  unsigned char fillCurve(vtkIdType i, double curvature, const ContactSpot& spot) const;
  void fillValidity(vtkIdType i, double curvature, const ContactSpot& spot) const;

  const AxisymmetricTool& Tool;
  const ResponseLaw& Law;
  const CurvatureBound& Curvature;
  ResponseMaterial Material;
  double StrainDepth;  ///< on a half-space
  double StrainRadius; ///< the contact radius there
  double HalfWidth;    ///< of the body
  double WidthDepth;   ///< on a half-space, where the contact radius is as large
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
