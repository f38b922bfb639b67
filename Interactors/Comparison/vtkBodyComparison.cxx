// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBodyComparison.h"

#include "Comparison/ComparisonColumn.h"
#include "vtkContactScene.h"
#include "vtkContactTool.h"
#include "vtkHapticSession.h"
#include "vtkRegimeMap.h"
#include "vtkResponseChart.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
// Offset between the centre of the picture and the centre of the area that title, legend and
// caption leave free, as fractions of half the picture's size.
constexpr double LegendShare = 0.28;
constexpr double CaptionShare = -0.10;
constexpr double Zoom = 1.2;
// Length of the longest arrow, mm; see vtkContactScene::SetLargestForce.
constexpr double ArrowRoom = 42.0;
} // namespace

struct vtkBodyComparison::Columns
{
  std::array<palpate::ComparisonColumn, 2> column;
  std::vector<palpate::ComparedTool> tools;

  palpate::ComparisonColumn& of(int side) { return this->column[side == Right ? 1 : 0]; }
  const palpate::ToolRegime* regime(int side, int tool)
  {
    const auto& judged = this->of(side).statement().tools;
    const auto index = static_cast<std::size_t>(tool);
    return tool >= 0 && index < judged.size() ? &judged[index] : nullptr;
  }
};

vtkStandardNewMacro(vtkBodyComparison);

vtkBodyComparison::vtkBodyComparison()
  : Parts(std::make_unique<Columns>())
{
  this->ShareMaterial();
  this->SetDeflection(this->Deflection);
  this->GetRenderer(Right)->SetActiveCamera(this->GetRenderer(Left)->GetActiveCamera());
}

vtkBodyComparison::~vtkBodyComparison() = default;

void vtkBodyComparison::SetRenderWindow(vtkRenderWindow* window)
{
  // Half of the width of the line between the columns, as a fraction of the window's width.
  constexpr double Gap = 0.0004;
  this->Parts->column[0].addTo(window, 0.0, 0.5 - Gap);
  this->Parts->column[1].addTo(window, 0.5 + Gap, 1.0);
}

void vtkBodyComparison::SetBody(int side, vtkPolyData* body, const std::string& title)
{
  this->Parts->of(side).setBody(body, title);
  this->Modified();
}

vtkPolyData* vtkBodyComparison::GetBody(int side)
{
  return this->Parts->of(side).body();
}

void vtkBodyComparison::AddTool(vtkContactTool* tool, const std::string& responseName)
{
  this->Parts->tools.push_back({ tool, responseName });
  for (auto& column : this->Parts->column)
  {
    column.setTools(this->Parts->tools);
  }
  this->SetShownTool(this->ShownTool);
}

void vtkBodyComparison::RemoveAllTools()
{
  this->Parts->tools.clear();
  for (auto& column : this->Parts->column)
  {
    column.setTools({});
  }
  this->ShownTool = 0;
  this->Modified();
}

int vtkBodyComparison::GetNumberOfTools()
{
  return static_cast<int>(this->Parts->tools.size());
}

void vtkBodyComparison::SetShownTool(int tool)
{
  if (this->GetNumberOfTools() > 0)
  {
    this->ShownTool = std::clamp(tool, 0, this->GetNumberOfTools() - 1);
    for (auto& column : this->Parts->column)
    {
      column.setShownTool(static_cast<std::size_t>(this->ShownTool));
    }
    if (this->Color != Displacement)
    {
      this->SetColor(this->Color); // the maps show the results for the shown tool
    }
    this->Modified();
  }
}

void vtkBodyComparison::SetYoungsModulus(double modulus)
{
  this->YoungsModulus = modulus;
  this->ShareMaterial();
}

void vtkBodyComparison::SetPoissonRatio(double ratio)
{
  this->PoissonRatio = ratio;
  this->ShareMaterial();
}

void vtkBodyComparison::ShareMaterial()
{
  for (auto& column : this->Parts->column)
  {
    column.setMaterial({ this->YoungsModulus, this->PoissonRatio });
  }
  this->Modified();
}

void vtkBodyComparison::SetDeflection(double deflection)
{
  if (!(deflection > 0.0 && std::isfinite(deflection)))
  {
    vtkErrorMacro(<< "Deflection must be positive and finite (mm), but is " << deflection << ".");
    return;
  }
  this->Deflection = deflection;
  for (auto& column : this->Parts->column)
  {
    column.setDeflection(deflection);
  }
  this->Modified();
}

bool vtkBodyComparison::Report(const std::string& error)
{
  if (!error.empty())
  {
    vtkErrorMacro(<< "Nothing to compare: " << error << ".");
  }
  return error.empty();
}

bool vtkBodyComparison::SetColor(int color)
{
  this->Color = std::clamp<int>(color, Displacement, RegimeVerdict);
  this->Modified();
  bool good = true;
  for (auto& column : this->Parts->column)
  {
    good = good && this->Report(column.colorBy(this->Color - 1));
  }
  return good;
}

bool vtkBodyComparison::ShowTips(vtkPolyData* left, vtkPolyData* right, vtkIdType index)
{
  return this->Report(this->Parts->column[0].showTip(left, index)) &&
    this->Report(this->Parts->column[1].showTip(right, index));
}

bool vtkBodyComparison::ShowSessions(vtkHapticSession* left, vtkHapticSession* right)
{
  return this->Report(this->Parts->column[0].showSession(left)) &&
    this->Report(this->Parts->column[1].showSession(right));
}

bool vtkBodyComparison::ShowPlace(double x, double y, double z)
{
  const double place[3] = { x, y, z };
  return this->Report(this->Parts->column[0].showPlace(place)) &&
    this->Report(this->Parts->column[1].showPlace(place));
}

void vtkBodyComparison::LookAtBodies(const double direction[3], const double up[3])
{
  vtkBoundingBox all;
  for (const int side : { Left, Right })
  {
    double bounds[6];
    this->GetRenderer(side)->ComputeVisiblePropBounds(bounds);
    if (vtkMath::AreBoundsInitialized(bounds))
    {
      all.AddBounds(bounds);
    }
  }
  if (!all.IsValid())
  {
    return;
  }
  // Reserves space for the arrow of the largest force, even if no arrow is shown now.
  double unit[3] = { up[0], up[1], up[2] };
  vtkMath::Normalize(unit);
  for (const int side : { Left, Right })
  {
    if (this->GetBody(side))
    {
      double tip[3];
      this->GetBody(side)->GetCenter(tip);
      const double* box = this->GetBody(side)->GetBounds();
      for (int k = 0; k < 3; ++k)
      {
        const double half = 0.5 * (box[2 * k + 1] - box[2 * k]);
        tip[k] += unit[k] * (half + ArrowRoom);
      }
      all.AddPoint(tip);
    }
  }
  vtkRenderer* renderer = this->GetRenderer(Left);
  vtkCamera* camera = renderer->GetActiveCamera();
  double middle[3];
  double bounds[6];
  all.GetCenter(middle);
  all.GetBounds(bounds);
  camera->SetFocalPoint(middle);
  camera->SetPosition(middle[0] + direction[0], middle[1] + direction[1], middle[2] + direction[2]);
  camera->SetViewUp(up);
  renderer->ResetCamera(bounds);
  camera->Zoom(Zoom); // compensates ResetCamera, which fits the sphere around the bodies
  camera->SetWindowCenter(LegendShare, CaptionShare);
}

double vtkBodyComparison::GetForce(int side, int tool)
{
  const palpate::ToolRegime* regime = this->Parts->regime(side, tool);
  return regime ? regime->force : std::numeric_limits<double>::quiet_NaN();
}

double vtkBodyComparison::GetRegimeIndex(int side, int tool)
{
  const palpate::ToolRegime* regime = this->Parts->regime(side, tool);
  return regime ? regime->index : std::numeric_limits<double>::quiet_NaN();
}

double vtkBodyComparison::GetToolSensitivity(int side, int tool)
{
  const palpate::ToolRegime* regime = this->Parts->regime(side, tool);
  return regime ? regime->sensitivity : std::numeric_limits<double>::quiet_NaN();
}

int vtkBodyComparison::GetVerdict(int side)
{
  const palpate::RegimeStatement& statement = this->Parts->of(side).statement();
  return statement.tools.empty() ? -1 : statement.verdict;
}

double vtkBodyComparison::GetForceSpread(int side)
{
  return this->Parts->of(side).statement().spread;
}

void vtkBodyComparison::GetVerdictRange(int side, double range[2])
{
  range[0] = this->Parts->of(side).statement().from;
  range[1] = this->Parts->of(side).statement().to;
}

double vtkBodyComparison::GetValidity(int side)
{
  return this->Parts->of(side).statement().validity;
}

std::string vtkBodyComparison::GetStatement(int side)
{
  const palpate::RegimeStatement& statement = this->Parts->of(side).statement();
  return statement.tools.empty() ? std::string()
                                 : verdictInWords(statement) + "\n" + numbersInWords(statement);
}

vtkContactScene* vtkBodyComparison::GetScene(int side)
{
  return this->Parts->of(side).scene();
}

vtkRenderer* vtkBodyComparison::GetRenderer(int side)
{
  return this->Parts->of(side).renderer();
}

vtkResponseChart* vtkBodyComparison::GetChart(int side)
{
  return this->Parts->of(side).chart().chart();
}

vtkRegimeMap* vtkBodyComparison::GetMap(int side)
{
  return this->Parts->of(side).map();
}

void vtkBodyComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShownTool: " << this->ShownTool << " of " << this->GetNumberOfTools() << "\n";
  os << indent << "YoungsModulus: " << this->YoungsModulus << " MPa\n";
  os << indent << "PoissonRatio: " << this->PoissonRatio << "\n";
  os << indent << "Deflection: " << this->Deflection << " mm\n";
  os << indent << "Color: " << this->Color << "\n";
  for (const int side : { Left, Right })
  {
    os << indent << "Statement " << side << ": " << this->GetStatement(side) << "\n";
  }
}
