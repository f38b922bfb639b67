// SPDX-License-Identifier: BSD-3-Clause
// A session with kernels that the caller has made before. Start does not make them again, unless
// the body has changed in the meantime; the next Start does. The largest force of a device is also
// tested.
#include "Response/BodyConversion.h"
#include "Interaction/Session/BodyKernels.h"
#include "PlacedDevice.h"
#include "Haptics/Servo/ServoStep.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"

namespace
{
using namespace palpate::testing;

/// Force of the session after a start, at a depth of 1 mm.
double pressedForce(vtkHapticSession* session)
{
  return pressed(session, deviceOf(100.0, 1e6))->Force;
}

/// The same response with twice the force, which distinguishes it from the original.
Body strongerBody(vtkPolyData* body)
{
  Body stronger = Body::New();
  stronger->DeepCopy(body);
  for (const char* name : { "FlatForce", "FlatStiffness" })
  {
    vtkDataArray* array = stronger->GetPointData()->GetArray(name);
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      vtkFloatArray::SafeDownCast(array)->SetValue(
        i, 2.0F * vtkFloatArray::SafeDownCast(array)->GetValue(i));
    }
  }
  return stronger;
}

void checkGivenKernels(vtkPolyData* body)
{
  std::string error;
  palpate::BodyKernels kernels;
  kernels.read["Flat"] = palpate::makeContactBody(strongerBody(body), "Flat", error);
  PALPATE_CHECK(kernels.read["Flat"] && error.empty());

  vtkNew<vtkHapticSession> session;
  session->SetResponseName("Flat");
  session->SetBody(body);
  const double own = pressedForce(session);
  PALPATE_CHECK(own > 1.0);

  session->SetBody(body, kernels);
  // Twice the force, with the rounding of floats.
  PALPATE_CHECK_NEAR(pressedForce(session), 2.0 * own, 1e-5 * own);
  // The kernels are used for one Start only.
  PALPATE_CHECK_NEAR(pressedForce(session), own, 1e-12 * own);

  session->SetBody(body, kernels);
  body->Modified();
  PALPATE_CHECK_NEAR(pressedForce(session), own, 1e-12 * own);
}

void checkForceLimit()
{
  vtkNew<vtkHapticSession> session;
  PALPATE_CHECK(session->GetDevice()->GetMaximumForce() == 10.0); // see the header for "simulated"
  session->GetDevice()->SetSimulatedForce(12.0);
  PALPATE_CHECK(session->GetDevice()->GetMaximumForce() == 12.0);
  session->GetDevice()->Use(std::make_unique<PlacedDevice>(deviceOf(7.0, 1e6)));
  PALPATE_CHECK(session->GetDevice()->GetMaximumForce() == 7.0);
  PALPATE_CHECK(session->GetMaximumForce() == 7.0);
  session->GetSafety()->SetForceLimit(3.0);
  PALPATE_CHECK(session->GetMaximumForce() == 3.0);
  PALPATE_CHECK(session->GetDevice()->GetMaximumForce() == 7.0);
  session->GetSafety()->SetForceLimit(9.0);
  PALPATE_CHECK(session->GetMaximumForce() == 7.0);
}
} // namespace

int TestHapticSessionPrepared(int, char*[])
{
  const Body body = threeTools();
  checkGivenKernels(body);
  checkForceLimit();
  return palpate::testing::result();
}
