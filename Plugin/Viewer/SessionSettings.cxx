// SPDX-License-Identifier: BSD-3-Clause
#include "SessionSettings.h"

#include "Response/Files/CollectingWindow.h"
#include "Haptics/Devices/RecordedSetup.h"
#include "ScenePath.h"

#include "vtkHapticSession.h"

#include <limits>

namespace palpate
{
void chooseContact(
  const ViewerOptions& options, const ViewerScene& scene, vtkHapticSession* session)
{
  ContactSettings contact = options.contact;
  contact.friction.poissonRatio = scene.poissonRatio;
  session->GetSettings()->SetKernel(contact);
  session->SetBodyName(scene.title);
  session->SetMaterial(!scene.tissues.empty() ? scene.tissues
      : scene.stored                          ? std::string()
                     : materialInWords(scene.youngsModulus, scene.poissonRatio));
}

std::string openDevice(const ViewerOptions& options, vtkHapticSession* session)
{
  const QuietScope quiet;
  return session->GetDevice()->Open(options.device) ? std::string() : quiet.window->reason();
}

namespace
{
/// Removes the force limit of a simulated hand in a window. A mouse outputs no force. Therefore its
/// force is neither scaled nor limited.
void setLimits(vtkHapticSession* session, int hand)
{
  if (session->GetRealTime())
  {
    session->GetDevice(hand)->SetSimulatedForce(std::numeric_limits<double>::infinity());
  }
}
} // namespace

std::string chooseDevice(
  const ViewerOptions& options, const ResponseSet& responses, vtkHapticSession* session)
{
  const std::string error = openDevice(options, session);
  if (!error.empty())
  {
    return error;
  }
  session->GetDevice()->SetScale(options.scale);
  setLimits(session, 0);
  vtkHapticSafety* safety = session->GetSafety();
  safety->FitForceOn();
  safety->SetFitDepth(options.maximumDeflection);
  safety->ClearFitResponses();
  for (const std::string& name : responses.names)
  {
    safety->AddFitResponse(name);
  }
  return {};
}

std::string addHands(const ViewerOptions& options, vtkHapticSession* session)
{
  const QuietScope quiet;
  for (const std::string& name : options.hands)
  {
    const int hand = session->AddDevice(name);
    if (hand < 0)
    {
      return quiet.window->reason();
    }
    session->GetDevice(hand)->SetScale(options.scale);
    setLimits(session, hand);
  }
  return {};
}

void placeDevice(const ViewerScene& scene, const ResponseSet& responses, vtkHapticSession* session)
{
  constexpr double hover = 10.0; // height of the device's origin above the surface, mm
  const PictureAxes axes(scene);
  for (int hand = 0; hand < session->GetNumberOfDevices(); ++hand)
  {
    vtkHapticDevice* device = session->GetDevice(hand);
    if (device->IsPhysical())
    {
      device->SetOrigin(siteOfHand(scene, responses.body, hand).above(hover).data());
      device->SetRight(axes.right);
      device->SetUp(axes.up);
      device->SetClutchButtons(1);
    }
  }
}

std::string startQuietly(vtkHapticSession* session)
{
  const QuietScope quiet;
  const bool started = session->Start();
  if (started)
  {
    quiet.window->printWarnings();
  }
  return started ? std::string() : quiet.window->reason();
}
} // namespace palpate
