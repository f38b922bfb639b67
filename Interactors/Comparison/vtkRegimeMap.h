// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRegimeMap
 * @brief colours of a body that show where the shape of the tool has an effect, with a legend, in a
 * renderer
 *
 * The inputs are a renderer and the output of vtkContactRegime. One of the three arrays of this
 * output is drawn:
 * - Index, λ: orange if the deformation is global (1), white if it is local (0), violet if a base
 *   close to the surface stiffens the body (-1 and below);
 * - Sensitivity, S = dlnF/dln(size): from yellow (0, a point force suffices) to dark blue (1.5 and
 *   above);
 * - Verdict: blue, shape matters; orange, mixed; yellow, a point force suffices.
 *
 * Grey means that there is no stable contact. A colour represents the same number in every picture,
 * because the ranges do not depend on the data. The colours of sensitivity and verdicts differ in
 * lightness, so that they can be distinguished without colours and by colour-blind people. The
 * index is in violet and orange (ColorBrewer's PuOr).
 *
 * The arrays are uploaded to the graphics card once, and again only when the quantity changes.
 *
 * @code{.py}
 * colours = palpate.vtkRegimeMap()
 * colours.SetRenderer(renderer)
 * colours.SetBody(regime.GetOutput())                  # vtkContactRegime
 * colours.SetQuantityToSensitivity()
 * @endcode
 *
 * @sa vtkContactRegime vtkBodyComparison
 */
#ifndef vtkRegimeMap_h
#define vtkRegimeMap_h

#include "palpateComparisonModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <string> // For std::string

class vtkActor;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkRenderer;
class vtkScalarBarActor;

class PALPATECOMPARISON_EXPORT vtkRegimeMap : public vtkObject
{
public:
  static vtkRegimeMap* New();
  vtkTypeMacro(vtkRegimeMap, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of Quantity.
  enum MapQuantity
  {
    Index = 0,
    Sensitivity = 1,
    Verdict = 2
  };

  /** The renderer, to which the body and its legend are added. Call once. */
  void SetRenderer(vtkRenderer* renderer);

  /**
   * The body, with the arrays of vtkContactRegime. If an array is missing, SetBody reports an error
   * that names the array, returns false and leaves the display unchanged.
   */
  bool SetBody(vtkPolyData* body);

  ///@{
  /** The quantity shown by the colours. Default Index. */
  void SetQuantity(int quantity);
  vtkGetMacro(Quantity, int);
  void SetQuantityToIndex() { this->SetQuantity(Index); }
  void SetQuantityToSensitivity() { this->SetQuantity(Sensitivity); }
  void SetQuantityToVerdict() { this->SetQuantity(Verdict); }
  ///@}

  ///@{
  /** Whether body and legend are drawn. Default on. */
  void SetVisibility(bool visible);
  bool GetVisibility();
  ///@}

  ///@{
  /** The parts of the display. Use them to change style and position. The legend is at the right
   * edge. */
  vtkActor* GetBodyActor();
  vtkScalarBarActor* GetLegend();
  ///@}

protected:
  vtkRegimeMap();
  ~vtkRegimeMap() override;

private:
  vtkRegimeMap(const vtkRegimeMap&) = delete;
  void operator=(const vtkRegimeMap&) = delete;

  void PlaceLegend();

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkPolyDataMapper> Mapper;
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkScalarBarActor> Legend;
  int Quantity = Index;
};

#endif
