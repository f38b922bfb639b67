// SPDX-License-Identifier: BSD-3-Clause
// Values of a scene that are measured on the drawn geometry, not taken from the settings.
#ifndef palpate_testing_SceneParts_h
#define palpate_testing_SceneParts_h

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkHapticToolRepresentation.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkProp3DCollection.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace palpate::testing
{
/// Range of an actor along a direction, in world coordinates.
struct Extent
{
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double aside = 0.0; ///< largest distance from the line through `origin`
};

/// Returns the extent of the drawn points of `actor`, relative to `origin`, along the unit vector
/// `direction`.
inline Extent extentAlong(vtkActor* actor, const double origin[3], const double direction[3])
{
  actor->GetMapper()->Update();
  vtkPolyData* drawn = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  Extent extent;
  for (vtkIdType i = 0; i < drawn->GetNumberOfPoints(); ++i)
  {
    double p[4] = { 0.0, 0.0, 0.0, 1.0 };
    drawn->GetPoint(i, p);
    actor->GetMatrix()->MultiplyPoint(p, p);
    vtkMath::Subtract(p, origin, p);
    const double along = vtkMath::Dot(p, direction);
    extent.low = std::min(extent.low, along);
    extent.high = std::max(extent.high, along);
    const double squared = vtkMath::Dot(p, p) - along * along;
    extent.aside = std::max(extent.aside, std::sqrt(std::max(squared, 0.0)));
  }
  return extent;
}

/// The parts of a tool representation, in the order in which they were added.
struct ToolParts
{
  vtkActor* tool;
  vtkActor* arrow;
  vtkTextActor* label;

  explicit ToolParts(vtkHapticToolRepresentation* representation)
    : tool(vtkActor::SafeDownCast(representation->GetParts()->GetItemAsObject(0)))
    , arrow(vtkActor::SafeDownCast(representation->GetParts()->GetItemAsObject(1)))
    , label(vtkTextActor::SafeDownCast(representation->GetParts()->GetItemAsObject(2)))
  {
  }
};

/// All arrows of a tool representation with their labels, in the order in which they were added.
struct ForceParts
{
  vtkActor *total, *normal, *friction, *applied;
  vtkTextActor *totalLabel, *normalLabel, *frictionLabel, *appliedLabel;

  explicit ForceParts(vtkHapticToolRepresentation* representation)
  {
    vtkPropCollection* parts = representation->GetParts();
    const auto actor = [parts](int i) { return vtkActor::SafeDownCast(parts->GetItemAsObject(i)); };
    const auto text = [parts](int i)
    { return vtkTextActor::SafeDownCast(parts->GetItemAsObject(i)); };
    this->total = actor(1);
    this->totalLabel = text(2);
    this->normal = actor(3);
    this->normalLabel = text(4);
    this->friction = actor(5);
    this->frictionLabel = text(6);
    this->applied = actor(7);
    this->appliedLabel = text(8);
  }
};

/// The scale of forces in the corner of a scene: the last two of its props.
struct ScaleParts
{
  vtkActor2D* arrow;
  vtkTextActor* label;

  explicit ScaleParts(vtkRenderer* renderer)
  {
    vtkPropCollection* props = renderer->GetViewProps();
    const int count = props->GetNumberOfItems();
    this->arrow = vtkActor2D::SafeDownCast(props->GetItemAsObject(count - 2));
    this->label = vtkTextActor::SafeDownCast(props->GetItemAsObject(count - 1));
  }
};

/// Returns true if a box in world coordinates is completely inside the picture.
inline bool isInPicture(vtkRenderer* renderer, const double bounds[6])
{
  for (int corner = 0; corner < 8; ++corner)
  {
    double x = bounds[corner % 2];
    double y = bounds[2 + corner / 2 % 2];
    double z = bounds[4 + corner / 4];
    renderer->WorldToView(x, y, z);
    if (std::abs(x) > 1.0 || std::abs(y) > 1.0)
    {
      return false;
    }
  }
  return true;
}

/// The text in the corner of a scene: the text actor that is a separate prop.
inline std::string caption(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    if (auto* text = vtkTextActor::SafeDownCast(props->GetItemAsObject(i)))
    {
      return text->GetInput() ? text->GetInput() : "";
    }
  }
  return "";
}
} // namespace palpate::testing

#endif
