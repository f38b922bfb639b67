// SPDX-License-Identifier: BSD-3-Clause
#include "LiveTouchSession.h"

#include "Contact/ContactBody.h"
#include "Response/ResponseTool.h"

#include "vtkCallbackCommand.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"

#include <Eigen/Geometry>

#include <utility>

namespace palpate
{
namespace
{
constexpr double Lift = 3.0;   // height of a simulated hand above the surface at the start, mm
constexpr double Hover = 10.0; // height of a device's hand above the surface at the start, mm
// Distance, as a fraction of the body's size, beyond which a simulated hand is lifted.
constexpr double FarDistance = 0.1;

/// Stores the text of the session's errors, without the class name and the address that VTK adds.
void storeError(vtkObject*, unsigned long, void* kept, void* text)
{
  std::string error = static_cast<const char*>(text);
  const std::size_t start = error.find("): ");
  error.erase(0, start == std::string::npos ? 0 : start + 3);
  error.erase(error.find_last_not_of(" \n.") + 1);
  *static_cast<std::string*>(kept) = error;
}

/// Makes another object with the same arrays, because displayed objects cache their bounds.
vtkSmartPointer<vtkPolyData> sameArrays(vtkPolyData* body)
{
  auto view = vtkSmartPointer<vtkPolyData>::New();
  view->ShallowCopy(body);
  if (body->GetPoints())
  {
    vtkNew<vtkPoints> points;
    points->SetData(body->GetPoints()->GetData());
    view->SetPoints(points);
  }
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(body->GetFieldData());
  view->SetFieldData(fields);
  return view;
}
} // namespace

void LiveTouchSession::start(vtkPolyData* body, const std::string& response,
  const std::string& device, const TouchHandle& handle, const Sight& sight)
{
  this->stop();
  this->Device = device;
  this->Handle = handle;
  this->View = sight;
  this->Phase = State::Preparing;
  this->request(
    body, response, device, handle.isToBeFound ? std::optional<Sight>(sight) : std::nullopt);
}

void LiveTouchSession::replace(vtkPolyData* body, const std::string& response)
{
  // Before the session runs, no device is open. Therefore the request must name the device.
  this->request(body, response, this->Phase == State::Touching ? std::string() : this->Device);
}

void LiveTouchSession::request(vtkPolyData* body, const std::string& response,
  const std::string& device, const std::optional<Sight>& sight)
{
  this->Error.clear();
  this->Held.push_back(sameArrays(body));
  this->Background.submit({ this->Held.back(), response, device, sight });
}

void LiveTouchSession::stop()
{
  this->Background.cancel();
  if (this->Session)
  {
    this->Session->Stop();
  }
  this->Session = nullptr; // this also closes the device
  this->Phase = State::Idle;
  this->Kernels = {};
  this->Tool = nullptr;
  this->Body = nullptr;
  this->Error.clear();
  this->Warning.clear();
}

bool LiveTouchSession::collect()
{
  auto made = this->Background.collect();
  return made && this->take(*made);
}

bool LiveTouchSession::take(PreparedLiveTouch& made)
{
  const bool isDone =
    made.error.empty() && (this->Phase == State::Touching ? this->change(made) : this->begin(made));
  if (isDone)
  {
    this->Kernels = made.kernels;
    this->Body = made.request.body;
    this->Warning = made.warning;
    this->Peak = made.peak;
  }
  else
  {
    this->fail(made.error.empty() ? this->Complaint : made.error);
  }
  // The other thread has finished the newest request, and therefore all requests.
  this->Held.clear();
  return true;
}

bool LiveTouchSession::fail(const std::string& error)
{
  if (this->Phase != State::Touching)
  {
    this->stop();
  }
  this->Error = error;
  return false;
}

bool LiveTouchSession::begin(PreparedLiveTouch& made)
{
  this->Tool = findTool(nullptr, made.request.body, made.request.response, this->Complaint);
  if (!this->Tool)
  {
    return false;
  }
  this->Session = vtkSmartPointer<vtkHapticSession>::New();
  vtkNew<vtkCallbackCommand> hear;
  hear->SetClientData(&this->Complaint);
  hear->SetCallback(storeError);
  this->Session->AddObserver(vtkCommand::ErrorEvent, hear);
  this->Session->GetDevice()->AddObserver(vtkCommand::ErrorEvent, hear);

  if (made.request.sight)
  {
    this->Handle.position = made.start;
  }
  this->Place = findPlace(*made.kernels.read.begin()->second, this->Handle);
  vtkHapticDevice* device = this->Session->GetDevice();
  const bool isOfThisWorld = made.device != nullptr;
  if (isOfThisWorld)
  {
    const Eigen::Vector3d towards = this->View.towards.normalized();
    const Eigen::Vector3d right = this->View.up.cross(towards);
    const Eigen::Vector3d up = towards.cross(right);
    const Eigen::Vector3d origin = this->Place.surface + Hover * this->Place.normal;
    device->SetOrigin(origin.data());
    device->SetRight(right.data());
    device->SetUp(up.data());
    device->SetClutchButtons(1);
    device->Use(std::move(made.device));
  }
  else if (!device->Open(this->Device))
  {
    return false;
  }
  this->Session->RealTimeOn();
  this->Session->GetRecorder()->RecordingOff();
  this->Session->GetSafety()->FitForceOn();
  this->Session->GetSafety()->SetFitDepth(made.range);
  this->Session->SetResponseName(made.request.response);
  this->Session->SetBody(made.request.body, made.kernels);
  this->putDown();
  if (this->Session->GetState() == vtkHapticSession::Stopped)
  {
    return false;
  }
  this->Phase = State::Touching;
  return true;
}

bool LiveTouchSession::change(const PreparedLiveTouch& made)
{
  auto tool = findTool(nullptr, made.request.body, made.request.response, this->Complaint);
  if (!tool)
  {
    return false;
  }
  this->Session->GetSafety()->SetFitDepth(made.range);
  this->Session->SetResponseName(made.request.response);
  this->Session->SetBody(made.request.body, made.kernels);
  if (!this->Session->ApplyChanges())
  {
    return false;
  }
  this->Tool = tool;
  return true;
}

/// Starts the session with the hand above the target, and then moves the hand to the target.
void LiveTouchSession::putDown()
{
  const Eigen::Vector3d above = this->Place.surface + Lift * this->Place.normal;
  this->Session->GetDevice()->SteerTo(above.data());
  if (this->Session->Start())
  {
    this->Session->GetDevice()->SteerTo(this->Place.tip.data());
  }
}

bool LiveTouchSession::steer(const TouchHandle& handle)
{
  if (handle.isToBeFound)
  {
    return true;
  }
  this->Handle = handle;
  if (this->Phase != State::Touching || !this->Session->GetDevice()->IsSimulated() ||
    !handle.position.allFinite())
  {
    return true;
  }
  const LiveTouchPlace place = findPlace(*this->Kernels.read.begin()->second, handle);
  if (place.tip == this->Place.tip)
  {
    return true;
  }
  const double leap = (place.surface - this->Place.surface).norm();
  this->Place = place;
  if (!handle.snaps || leap < FarDistance * this->Body->GetLength())
  {
    this->Session->GetDevice()->SteerTo(place.tip.data());
    return true;
  }
  this->Session->Stop();
  // The kernels are set together with the body, so that Start need not make them.
  this->Session->SetBody(this->Body, this->Kernels);
  this->putDown();
  if (this->Session->GetState() == vtkHapticSession::Stopped)
  {
    this->Phase = State::Preparing; // there is no session that could continue
    return this->fail(this->Complaint);
  }
  return true;
}
} // namespace palpate
