// SPDX-License-Identifier: BSD-3-Clause
#include "vtkContactScene.h"

#include "Interaction/Display/BodyDisplay.h"
#include "Interaction/Display/ShownHands.h"
#include "Interaction/Display/ShownContact.h"
#include "Interaction/Display/ForceTrail.h"
#include "Interaction/Display/LabelLayout.h"
#include "Response/RoundNumber.h"
#include "Interaction/Display/ScaleRule.h"
#include "Interaction/Display/SceneView.h"
#include "Interaction/Display/SceneCaption.h"
#include "Interaction/Display/SceneLegends.h"
#include "vtkContactTool.h"
#include "vtkFrameClock.h"
#include "vtkHapticSession.h"
#include "vtkHapticToolRepresentation.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace
{
constexpr double ArrowLength = 40.0; // mm, length of the arrow of the largest force
} // namespace

vtkStandardNewMacro(vtkContactScene);

vtkContactScene::vtkContactScene()
  : Legends(std::make_unique<palpate::SceneLegends>())
  , Body(std::make_unique<palpate::BodyDisplay>(this->Legends->displacementColors()))
  , Hands(std::make_unique<palpate::ShownHands>())
  , Trail(std::make_unique<palpate::ForceTrail>(this->Legends->forceColors()))
  , Scale(std::make_unique<palpate::ForceScale>())
  , Caption(std::make_unique<palpate::SceneCaption>())
  , Marker(palpate::makePlaceMarker())
  , ForceRule(std::make_unique<palpate::ScaleRule>())
  , Shown(std::make_unique<palpate::ShownContact>())
{
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
  renderer->AddViewProp(this->Body->actor());
  renderer->AddViewProp(this->Trail->actor());
  this->Hands->setRenderer(renderer);
  const std::initializer_list<vtkProp*> props = { this->Marker, this->Legends->displacement(),
    this->Legends->force(), this->Caption->actor(), this->Scale->arrow(), this->Scale->label() };
  for (vtkProp* prop : props)
  {
    renderer->AddViewProp(prop);
  }
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
  this->Hands->setTool(tool);
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

void vtkContactScene::SetLargestDeflection(double largest)
{
  this->Legends->setLargestDisplacement(largest);
}

void vtkContactScene::SetLargestForce(double largest)
{
  if (!(largest > 0.0) || !std::isfinite(largest))
  {
    vtkErrorMacro(<< "The largest force must be finite and positive (N), but is " << largest
                  << ".");
    return;
  }
  this->IsScaleNew = this->IsScaleNew || largest != this->LargestForce;
  this->LargestForce = largest;
  const double scale = palpate::roundDown(ArrowLength / largest);
  this->Hands->tool()->SetForceScale(scale);
  this->Scale->choose(largest, scale);
  this->Legends->setLargestForce(palpate::roundUp(largest));
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

void vtkContactScene::SetTrailVisibility(bool visible)
{
  this->TrailVisibility = visible;
  this->SwitchTrail();
}

void vtkContactScene::SetBlind(bool blind)
{
  this->Blind = blind;
  this->Hands->setVisibility(!blind);
  this->Legends->displacement()->SetVisibility(!blind);
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
  this->Trail->show(contacts);
  this->SwitchTrail();
  return true;
}

void vtkContactScene::ClearTrail()
{
  this->Trail->clear();
  this->SwitchTrail();
}

void vtkContactScene::SwitchTrail()
{
  const bool visible = this->TrailVisibility && !this->Blind && !this->Trail->isEmpty();
  this->Trail->actor()->SetVisibility(visible);
  this->Legends->explainGaps(visible ? this->Trail->gapsInWords() : std::string());
  this->Legends->force()->SetVisibility(visible);
  constexpr std::size_t segments = 40; // number of segments of the trail that labels avoid
  this->Hands->leaveFree(
    visible ? this->Trail->segments(segments) : std::vector<palpate::LabelObstacle>());
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
  this->Scale->setChanged(false);
  this->Hands->setSteadyLabels(false);
  this->Show({ contact });
  return true;
}

void vtkContactScene::ShowContact(const double tip[3], const double contactPoint[3],
  const double normal[3], const double force[3], double deflection, vtkIdType cell)
{
  palpate::ShownContact contact =
    palpate::contactOfNumbers(tip, contactPoint, normal, force, deflection, cell);
  palpate::findValidity(this->BodyData, this->ResponseName, contact);
  this->Show({ contact });
}

void vtkContactScene::Show(const std::vector<palpate::ShownContact>& contacts)
{
  const palpate::ShownContact& contact = contacts.front();
  *this->Shown = contact;
  this->Shown->hasApplied &= this->Hands->tool()->GetAppliedForceVisibility();
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
    this->Hands->resize(contacts.size());
    this->Body->show(contacts);
    this->ContactRadius = contact.touches() ? this->Body->contactRadius() : 0.0;
    vtkContactTool* tool = this->Hands->tool()->GetTool();
    this->Legends->explainCircle(this->ContactCircleVisibility);
    this->Caption->describe(*this->Shown, tool ? tool->GetDescription() : std::string(),
      this->ContactRadius, this->GetExaggeration());
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
      const double radius = this->ContactCircleVisibility ? this->Body->contactRadius(i) : 0.0;
      this->Hands->show(
        i, contacts[i], radius, this->GetExaggeration() * this->Body->circleDepth(i));
      if (i > 0)
      {
        this->Caption->addHand(static_cast<int>(i) + 1, contacts[i]);
      }
    }
  }
  this->Arrange();
}

void vtkContactScene::ShowBlind(const palpate::ShownContact& contact)
{
  palpate::placeMarker(contact, this->Marker);
  this->Caption->describeNothing();
  this->Hands->hideCircles();
  palpate::ShownContact unseen = contact;
  unseen.cell = -1; // without a cell the dent is not drawn
  this->Body->show(unseen);
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

void vtkContactScene::Arrange()
{
  if (!this->Renderer)
  {
    return;
  }
  if (this->Renderer->IsActiveCameraCreated())
  {
    this->Scale->place(this->Renderer, Eigen::Vector3d(this->Contact));
  }
  this->Caption->write(this->Renderer->GetSize()[0] - this->Scale->width());
  // The legends are placed above the caption and the scale.
  this->Legends->place(this->Renderer, this->Caption->height());
}

void vtkContactScene::LookAtBody(const double direction[3], const double up[3])
{
  std::copy_n(direction, 3, this->BodyDirection);
  std::copy_n(up, 3, this->BodyUp);
  this->HasBodyView = true;
  double bounds[6];
  this->Body->bounds(bounds);
  vtkBoundingBox all(bounds);
  if (!this->Blind)
  {
    this->Hands->addBounds(all); // the arrows are included, so that all of them are visible
  }
  all.GetBounds(bounds);
  palpate::lookAtBounds(this->Renderer, bounds, { Eigen::Vector3d(direction), Eigen::Vector3d(up) },
    palpate::SceneLegends::share(this->Renderer));
}

void vtkContactScene::ResetView()
{
  if (this->HasBodyView)
  {
    const Eigen::Vector3d direction(this->BodyDirection);
    const Eigen::Vector3d up(this->BodyUp);
    this->LookAtBody(direction.data(), up.data());
  }
  else if (this->Renderer)
  {
    this->Renderer->ResetCamera();
  }
}

void vtkContactScene::LookAtContact(double distance, const double direction[3], const double up[3])
{
  palpate::lookAtPoint(this->Renderer, Eigen::Vector3d(this->Contact), distance,
    { Eigen::Vector3d(direction), Eigen::Vector3d(up) },
    palpate::SceneLegends::share(this->Renderer));
}

vtkHapticToolRepresentation* vtkContactScene::GetToolRepresentation()
{
  return this->Hands->tool();
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
  return this->Hands->circle();
}

vtkScalarBarActor* vtkContactScene::GetLegend()
{
  return this->Legends->displacement();
}

vtkScalarBarActor* vtkContactScene::GetTrailLegend()
{
  return this->Legends->force();
}

void vtkContactScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
  os << indent << "ResponseName: " << this->ResponseName << "\n";
  os << indent << "Blind: " << this->Blind << "\n";
  os << indent << "Exaggeration: " << this->GetExaggeration() << "\n";
  os << indent << "LargestForce: " << this->LargestForce << " N\n";
  os << indent << "TrailLength: " << this->TrailLength << "\n";
}
