// SPDX-License-Identifier: BSD-3-Clause
#include "Interaction/Session/SessionSetup.h"

#include "Contact/ResponseContract.h"
#include "Mechanics/JoinedText.h"
#include "Response/BodyConversion.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

namespace palpate
{
namespace
{
/// Describes the layers of a stack: "2 mm, E = 0.1 MPa, nu = 0.45; half-space, E = 1 MPa, nu =
/// 0.45, slipping".
std::string layersInWords(vtkPolyData* body, const std::string& name)
{
  vtkDataArray* layers =
    body->GetFieldData()->GetArray(arrayName(name, ResponseArray::LayerStack).c_str());
  std::string text;
  for (vtkIdType i = 0;
       layers && layers->GetNumberOfComponents() == 4 && i < layers->GetNumberOfTuples(); ++i)
  {
    const double thickness = layers->GetComponent(i, 0);
    text += text.empty() ? "" : "; ";
    text += thickness > 0.0 ? joined(thickness, " mm") : std::string("half-space");
    text += ", " + materialInWords(layers->GetComponent(i, 1), layers->GetComponent(i, 2));
    text += layers->GetComponent(i, 3) != 0.0 ? ", slipping" : "";
  }
  return text;
}
} // namespace

RecordedSetup setupOf(vtkPolyData* body, const std::string& name, const std::string& bodyName,
  const std::string& material, const FrictionSettings& friction)
{
  RecordedSetup setup;
  setup[SetupPart::Body] = bodyName;
  setup[SetupPart::Material] = material;
  setup[SetupPart::Friction] = frictionInWords(friction);
  if (body)
  {
    setup[SetupPart::Tool] = responseText(body, name, ResponseArray::Tool);
    setup[SetupPart::Model] = responseText(body, name, ResponseArray::Model);
    const std::string layers = layersInWords(body, name);
    setup[SetupPart::Model] += layers.empty() ? "" : " (" + layers + ")";
  }
  return setup;
}
} // namespace palpate
