// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactScene.h"

#include "Interaction/Display/BodyDisplay.h"
#include "Interaction/Display/ColorLegend.h"
#include "Interaction/Display/ContactCircle.h"
#include "Interaction/Display/ContactReading.h"
#include "Interaction/Display/ContactValidity.h"
#include "Interaction/Display/DisplayColors.h"
#include "Interaction/Display/ForceScale.h"
#include "Interaction/Display/ForceTrail.h"
#include "Interaction/Display/RoundNumber.h"
#include "Interaction/Display/SceneCamera.h"
#include "Interaction/Display/SceneCaption.h"
#include "Interaction/Display/SceneLight.h"
#include "Interaction/Display/ShownContact.h"
#include "vtkContactTool.h"
#include "vtkHapticSession.h"
#include "vtkHapticToolRepresentation.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkSphereSource.h"
#include "vtkTextActor.h"

#include <algorithm>
#include <vector>

namespace
{
constexpr double ArrowLength = 40.0; // mm, of the largest force
constexpr double MarkerRadius = 2.0; // mm
constexpr int LegendSize = 15;
constexpr double LegendWidth = 175.0;   // pixels
constexpr double CaptionHeight = 160.0; // pixels free below the legends, so that they stay put
constexpr double LegendBottom = 0.15;
constexpr double LegendTop = 0.97;
} // namespace

vtkStandardNewMacro(vtkContactScene);

vtkContactScene::vtkContactScene()
  : Colors(vtkSmartPointer<vtkLookupTable>::New())
  , ForceColors(vtkSmartPointer<vtkLookupTable>::New())
  , Body(std::make_unique<palpate::BodyDisplay>(this->Colors))
  , Circle(std::make_unique<palpate::ContactCircle>())
  , Trail(std::make_unique<palpate::ForceTrail>(this->ForceColors))
  , Scale(std::make_unique<palpate::ForceScale>())
  , Caption(std::make_unique<palpate::SceneCaption>())
  , Legend(vtkSmartPointer<vtkScalarBarActor>::New())
  , TrailLegend(vtkSmartPointer<vtkScalarBarActor>::New())
  , ToolRepresentation(vtkSmartPointer<vtkHapticToolRepresentation>::New())
  , Marker(vtkSmartPointer<vtkActor>::New())
  , Shown(std::make_unique<palpate::ShownContact>())
{
  palpate::fillColors(this->Colors, palpate::DeflectionColors);
  this->Colors->SetVectorModeToMagnitude();
  palpate::fillColors(this->ForceColors, palpate::TrailColors);
  palpate::styleLegend(this->Legend, this->Colors, "Displacement (mm)", LegendSize);
  palpate::styleLegend(this->TrailLegend, this->ForceColors, "Force (N)", LegendSize);
  this->TrailLegend->SetLabelFormat("%.4g");
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(MarkerRadius);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  vtkNew<vtkPolyDataMapper> ballMapper;
  ballMapper->SetInputConnection(ball->GetOutputPort());
  this->Marker->SetMapper(ballMapper);
  this->Marker->GetProperty()->SetColor(
    palpate::ToolColor[0], palpate::ToolColor[1], palpate::ToolColor[2]);
  this->Marker->VisibilityOff();
  this->SetLargestDeflection(1.0);
  this->SetLargestForce(1.0);
  this->SwitchTrail();
}

vtkContactScene::~vtkContactScene()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->RenderObserver);
  }
}

void vtkContactScene::SetRenderer(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  palpate::lightScene(renderer);
  renderer->AddActor(this->Body->actor());
  renderer->AddActor(this->Trail->actor());
  renderer->AddActor(this->Circle->actor());
  renderer->AddViewProp(this->ToolRepresentation);
  renderer->AddActor(this->Marker);
  renderer->AddViewProp(this->Legend);
  renderer->AddViewProp(this->TrailLegend);
  renderer->AddViewProp(this->Caption->actor());
  renderer->AddViewProp(this->Scale->arrow());
  renderer->AddViewProp(this->Scale->label());
  this->RenderObserver =
    renderer->AddObserver(vtkCommand::StartEvent, this, &vtkContactScene::Arrange);
}

vtkRenderer* vtkContactScene::GetRenderer()
{
  return this->Renderer;
}

void vtkContactScene::SetBody(vtkPolyData* body)
{
  this->BodyData = body;
  this->Body->setBody(body);
}

void vtkContactScene::SetTool(vtkContactTool* tool)
{
  this->Body->setTool(tool);
  this->ToolRepresentation->SetTool(tool);
}

void vtkContactScene::SetPoissonRatio(double ratio)
{
  this->Body->setPoissonRatio(ratio);
}

void vtkContactScene::SetResponseName(const std::string& name)
{
  this->ResponseName = name;
  this->Body->setResponseName(name);
}

std::string vtkContactScene::GetResponseName()
{
  return this->ResponseName;
}

void vtkContactScene::SetLargestDeflection(double largest)
{
  this->Colors->SetTableRange(0.0, largest);
}

void vtkContactScene::SetLargestForce(double largest)
{
  const double scale = palpate::roundDown(ArrowLength / largest);
  this->ToolRepresentation->SetForceScale(scale);
  this->Scale->choose(largest, scale);
  this->ForceColors->SetTableRange(0.0, palpate::roundUp(largest));
}

void vtkContactScene::SetExaggeration(double factor)
{
  this->Body->setExaggeration(factor);
}

double vtkContactScene::GetExaggeration()
{
  return this->Body->exaggeration();
}

void vtkContactScene::SetDeflectionByShader(bool on)
{
  this->Body->setByShader(on);
}

bool vtkContactScene::GetDeflectionByShader()
{
  return this->Body->byShader();
}

void vtkContactScene::SetTitle(const std::string& title)
{
  this->Caption->setTitle(title);
}

void vtkContactScene::SetRemark(const std::string& remark)
{
  this->Caption->setRemark(remark);
}

void vtkContactScene::SetComponentsVisibility(bool visible)
{
  this->ToolRepresentation->SetComponentsVisibility(visible);
}

bool vtkContactScene::GetComponentsVisibility()
{
  return this->ToolRepresentation->GetComponentsVisibility();
}

void vtkContactScene::SetAppliedForceVisibility(bool visible)
{
  this->ToolRepresentation->SetAppliedForceVisibility(visible);
}

bool vtkContactScene::GetAppliedForceVisibility()
{
  return this->ToolRepresentation->GetAppliedForceVisibility();
}

void vtkContactScene::SetContactCircleVisibility(bool visible)
{
  this->CircleVisible = visible;
}

bool vtkContactScene::GetContactCircleVisibility()
{
  return this->CircleVisible;
}

void vtkContactScene::SetTrailVisibility(bool visible)
{
  this->TrailVisible = visible;
  this->SwitchTrail();
}

bool vtkContactScene::GetTrailVisibility()
{
  return this->TrailVisible;
}

void vtkContactScene::SetBlind(bool blind)
{
  this->Blind = blind;
  this->ToolRepresentation->SetVisibility(!blind);
  this->Legend->SetVisibility(!blind);
  this->Scale->setVisibility(!blind);
  this->Marker->SetVisibility(blind);
  this->SwitchTrail();
}

bool vtkContactScene::ShowTrail(vtkPolyData* probed)
{
  std::vector<palpate::ShownContact> contacts(
    static_cast<std::size_t>(probed->GetNumberOfPoints()));
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    if (!palpate::readTip(probed, static_cast<vtkIdType>(i), contacts[i]))
    {
      vtkErrorMacro(<< "A trail needs the output of a vtkToolContactProbe.");
      return false;
    }
    palpate::findValidity(this->BodyData, this->ResponseName, contacts[i]);
  }
  this->Trail->clear();
  this->TrailIsLive = false;
  std::for_each(contacts.begin(), contacts.end(),
    [this](const palpate::ShownContact& contact) { this->Trail->add(contact); });
  this->Trail->draw();
  this->SwitchTrail();
  return true;
}

void vtkContactScene::SetTrailLength(int contacts)
{
  this->TrailLength = std::max(contacts, 0);
}

int vtkContactScene::GetTrailLength()
{
  return this->TrailLength;
}

void vtkContactScene::ClearTrail()
{
  this->Trail->clear();
  this->Trail->draw();
  this->SwitchTrail();
}

void vtkContactScene::SwitchTrail()
{
  const bool visible = this->TrailVisible && !this->Blind && !this->Trail->isEmpty();
  this->Trail->actor()->SetVisibility(visible);
  this->TrailLegend->SetVisibility(visible);
}

bool vtkContactScene::ShowTip(vtkPolyData* probed, vtkIdType index)
{
  palpate::ShownContact contact;
  if (!palpate::readTip(probed, index, contact))
  {
    vtkErrorMacro(<< "Tip " << index << " of " << probed->GetNumberOfPoints()
                  << ": not a tip of a vtkToolContactProbe's output.");
    return false;
  }
  palpate::findValidity(this->BodyData, this->ResponseName, contact);
  this->Show(contact);
  return true;
}

void vtkContactScene::ShowSession(vtkHapticSession* session)
{
  const double asItWas[3] = { 0.0, 0.0, 0.0 };
  this->ShowSession(session, asItWas);
}

void vtkContactScene::ShowSession(vtkHapticSession* session, const double freeDirection[3])
{
  palpate::ShownContact contact = palpate::readSession(session);
  if (!contact.touches())
  {
    contact.tick.contact.normal = Eigen::Vector3d(freeDirection);
  }
  palpate::findValidity(session->GetBody(), session->GetResponseName(), contact);
  if (!this->TrailIsLive)
  {
    this->Trail->clear();
    this->TrailIsLive = true;
  }
  this->Trail->add(contact);
  this->Trail->keep(static_cast<std::size_t>(this->TrailLength));
  this->Trail->draw();
  this->SwitchTrail();
  this->Show(contact);
}

void vtkContactScene::ShowContact(const double tip[3], const double contactPoint[3],
  const double normal[3], const double force[3], double deflection, vtkIdType cell)
{
  palpate::ShownContact contact;
  contact.tick.tip = Eigen::Vector3d(tip);
  contact.tick.idealForce = Eigen::Vector3d(force);
  contact.tick.contact.contactPoint = Eigen::Vector3d(contactPoint);
  contact.tick.contact.normal = Eigen::Vector3d(normal);
  contact.tick.contact.deflection = deflection;
  contact.cell = cell;
  palpate::findValidity(this->BodyData, this->ResponseName, contact);
  this->Show(contact);
}

void vtkContactScene::Show(const palpate::ShownContact& contact)
{
  *this->Shown = contact;
  this->Shown->hasApplied &= this->GetAppliedForceVisibility();
  if (contact.touches() || !this->HasTouched)
  {
    std::copy_n(contact.tick.contact.contactPoint.data(), 3, this->Contact);
    this->HasTouched = contact.touches();
  }
  if (this->Blind)
  {
    this->ShowBlind(contact);
  }
  else
  {
    this->Body->show(contact);
    this->ContactRadius = contact.touches() ? this->Body->contactRadius() : 0.0;
    this->ToolRepresentation->SetBeyondValidity(!contact.isValid());
    const palpate::Tick& tick = contact.tick;
    this->ToolRepresentation->SetContact(tick.tip.data(), tick.contact.normal.data(),
      tick.contact.contactPoint.data(), tick.idealForce.data(), tick.contact.friction.data(),
      (this->Shown->hasApplied ? tick.appliedForce : tick.idealForce).data());
    this->ShowCircle(contact);
    vtkContactTool* tool = this->ToolRepresentation->GetTool();
    this->Caption->describe(*this->Shown, tool ? tool->GetDescription() : std::string(),
      this->ContactRadius, this->GetExaggeration());
  }
  this->Arrange();
}

void vtkContactScene::ShowBlind(const palpate::ShownContact& contact)
{
  // On the surface: how deep the hand gets would tell how hard the body pushes back.
  const Eigen::Vector3d& place =
    contact.touches() ? contact.tick.contact.contactPoint : contact.tick.tip;
  this->Marker->SetPosition(place.x(), place.y(), place.z());
  this->Caption->describeNothing();
  this->Circle->hide();
  palpate::ShownContact unseen = contact;
  unseen.cell = -1; // no dent
  this->Body->show(unseen);
}

void vtkContactScene::ShowCircle(const palpate::ShownContact& contact)
{
  const double depth = this->GetExaggeration() * this->Body->circleDepth();
  const palpate::Contact& felt = contact.tick.contact;
  this->Circle->show(felt.contactPoint - depth * felt.normal, felt.normal,
    this->CircleVisible ? this->ContactRadius : 0.0, !contact.isValid());
}

double vtkContactScene::GetContactRadius()
{
  return this->ContactRadius;
}

double vtkContactScene::GetValidity()
{
  return this->Shown->validity;
}

bool vtkContactScene::IsValid()
{
  return this->Shown->isValid();
}

void vtkContactScene::SetFieldRadius(double radius)
{
  this->Body->setFieldRadius(radius);
}

double vtkContactScene::GetLegendShare()
{
  // The same size in pixels, however narrow the viewport.
  const int width = this->Renderer ? std::max(this->Renderer->GetSize()[0], 1) : 1;
  return std::min(1.0, LegendWidth / static_cast<double>(width));
}

void vtkContactScene::Arrange()
{
  if (!this->Renderer)
  {
    return;
  }
  const int* size = this->Renderer->GetSize();
  if (this->Renderer->IsActiveCameraCreated())
  {
    this->Scale->place(this->Renderer, Eigen::Vector3d(this->Contact));
  }
  this->Caption->write(size[0] - this->Scale->width());
  // The legends in a column at the right edge, above caption and scale.
  const double share = this->GetLegendShare();
  const double reserved = std::max(CaptionHeight, this->Caption->height());
  const double low = std::min(std::max(reserved / std::max(size[1], 1), LegendBottom), 0.4);
  const bool two = this->TrailLegend->GetVisibility() != 0;
  const auto place = [share](vtkScalarBarActor* legend, double bottom, double top)
  {
    legend->GetPositionCoordinate()->SetValue(1.0 - share, bottom);
    legend->SetWidth(0.85 * share);
    legend->SetHeight(top - bottom);
  };
  const double middle = 0.5 * (low + LegendTop);
  if (two)
  {
    place(this->TrailLegend, low, middle - 0.02);
    place(this->Legend, middle + 0.02, LegendTop);
  }
  else
  {
    place(this->Legend, std::max(low, 0.25), std::max(low, 0.25) + 0.5);
  }
}

void vtkContactScene::LookAtBody(const double direction[3], const double up[3])
{
  double bounds[6];
  this->Body->bounds(bounds);
  vtkBoundingBox all(bounds);
  const double* tool = this->ToolRepresentation->GetBounds();
  if (tool && !this->Blind)
  {
    all.AddBounds(tool); // with the arrow: neither is to be cut off
  }
  all.GetBounds(bounds);
  palpate::lookAtBounds(this->Renderer, bounds, { Eigen::Vector3d(direction), Eigen::Vector3d(up) },
    this->GetLegendShare());
}

void vtkContactScene::LookAtContact(double distance, const double direction[3], const double up[3])
{
  palpate::lookAtPoint(this->Renderer, Eigen::Vector3d(this->Contact), distance,
    { Eigen::Vector3d(direction), Eigen::Vector3d(up) }, this->GetLegendShare());
}

vtkHapticToolRepresentation* vtkContactScene::GetToolRepresentation()
{
  return this->ToolRepresentation;
}

vtkActor* vtkContactScene::GetBodyActor()
{
  return this->Body->actor();
}

vtkActor* vtkContactScene::GetTrailActor()
{
  return this->Trail->actor();
}

vtkActor* vtkContactScene::GetCircleActor()
{
  return this->Circle->actor();
}

vtkScalarBarActor* vtkContactScene::GetLegend()
{
  return this->Legend;
}

vtkScalarBarActor* vtkContactScene::GetTrailLegend()
{
  return this->TrailLegend;
}

void vtkContactScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "Blind: " << this->Blind << "\n";
  os << indent << "Exaggeration: " << this->GetExaggeration() << "\n";
  os << indent << "TrailLength: " << this->TrailLength << "\n";
}
