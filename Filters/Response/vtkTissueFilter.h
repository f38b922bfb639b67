// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkTissueFilter
 * @brief base class of the filters that press a tool into an elastic body
 *
 * This abstract class has the settings of material, strain, depth and error. Lengths are in mm, and
 * moduli are in MPa.
 *
 * @code{.py}
 * response = palpate.vtkToolContactResponse()          # is a vtkTissueFilter
 * response.SetYoungsModulus(0.05)                      # MPa
 * response.SetStrainModelToNeoHooke()
 * response.SetMaximumDeflection(1.0)                   # mm
 * @endcode
 *
 * @sa vtkResponseFilter vtkDirectContactResponse
 */
#ifndef vtkTissueFilter_h
#define vtkTissueFilter_h

#include "Mechanics/FiniteStrain/StrainLaw.h" // For palpate::StrainLaw
#include "palpateResponseModule.h"            // For export macro
#include "vtkToolFilter.h"

class PALPATERESPONSE_EXPORT vtkTissueFilter : public vtkToolFilter
{
public:
  vtkTypeMacro(vtkTissueFilter, vtkToolFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Young's modulus E, MPa, > 0, default 0.1. Poisson's ratio, 0 to 0.5 (for finite elements at
   * most 0.499), default 0.45. They are used where no array gives the value.
   */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  /// Values of StrainModel.
  enum StrainModelType
  {
    SmallStrain = 0,
    NeoHooke = 1,
    Ogden = 2,
    Demiray = 3
  };

  ///@{
  /**
   * Law of the body at large strain. SmallStrain (default) uses the exact laws of linear
   * elasticity. The other laws are NeoHooke, Ogden with one term of the exponent OgdenExponent, and
   * Demiray with the exponent DemirayExponent. Modulus and Poisson's ratio are those at small
   * strain.
   */
  vtkSetClampMacro(StrainModel, int, SmallStrain, Demiray);
  vtkGetMacro(StrainModel, int);
  void SetStrainModelToSmallStrain() { this->SetStrainModel(SmallStrain); }
  void SetStrainModelToNeoHooke() { this->SetStrainModel(NeoHooke); }
  void SetStrainModelToOgden() { this->SetStrainModel(Ogden); }
  void SetStrainModelToDemiray() { this->SetStrainModel(Demiray); }
  ///@}

  ///@{
  /** Ogden's exponent, not 0, default 2 (Neo-Hooke). Demiray's exponent b, > 0, default 1. */
  vtkSetMacro(OgdenExponent, double);
  vtkGetMacro(OgdenExponent, double);
  vtkSetMacro(DemirayExponent, double);
  vtkGetMacro(DemirayExponent, double);
  ///@}

  ///@{
  /** Depth of the last sample, mm, > 0. Default 2. */
  vtkSetMacro(MaximumDeflection, double);
  vtkGetMacro(MaximumDeflection, double);
  ///@}

  ///@{
  /**
   * Relative error of the force up to which the response is valid. palpate/ErrorRule.h estimates
   * the error. Default 0.05, which is 5 %.
   */
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

protected:
  vtkTissueFilter() = default;
  ~vtkTissueFilter() override = default;

  palpate::StrainLaw strainLaw() const
  {
    return palpate::strainLawOf(this->StrainModel, this->OgdenExponent, this->DemirayExponent);
  }

  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  int StrainModel = SmallStrain;
  double OgdenExponent = 2.0;
  double DemirayExponent = 1.0;
  double MaximumDeflection = 2.0;
  double ErrorTolerance = 0.05;

private:
  vtkTissueFilter(const vtkTissueFilter&) = delete;
  void operator=(const vtkTissueFilter&) = delete;
};

#endif
