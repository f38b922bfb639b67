// SPDX-License-Identifier: BSD-3-Clause
#ifndef ComparisonColumn_h
#define ComparisonColumn_h

#include "Comparison/ComparisonChart.h"
#include "Comparison/RegimeStatement.h"
#include "Comparison/VerdictPanel.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkContactScene;
class vtkHapticSession;
class vtkPolyData;
class vtkRegimeMap;
class vtkRenderWindow;
class vtkRenderer;
class vtkTextActor;

namespace palpate
{
/// One of the compared bodies. The column shows from top to bottom: title, the body under the tool
/// or its regime map, the curves of all tools at the contact, and the verdict. Functions that
/// return text return "" or an error message.
class ComparisonColumn
{
public:
  ComparisonColumn();
  ~ComparisonColumn();
  ComparisonColumn(const ComparisonColumn&) = delete;
  ComparisonColumn& operator=(const ComparisonColumn&) = delete;

  /// Assigns the column to the part of the window from `left` to `right`, as fractions of its
  /// width.
  void addTo(vtkRenderWindow* window, double left, double right);

  // The following functions set the body, the tools and the material. The verdict is computed when
  // a contact or a point is shown.
  void setBody(vtkPolyData* body, const std::string& title);
  void setTools(const std::vector<ComparedTool>& tools);
  void setMaterial(const ComparedMaterial& material);
  void setDeflection(double deflection);
  void setShownTool(std::size_t tool);

  std::string showTip(vtkPolyData* probed, vtkIdType index);
  std::string showSession(vtkHapticSession* session);
  /// Shows curves and verdict at the point of the body that is nearest to `place`, mm.
  std::string showPlace(const double place[3]);
  /// Colours the body by the displacement if `quantity` is -1, otherwise by this
  /// vtkRegimeMap::MapQuantity for the shown tool.
  std::string colorBy(int quantity);

  vtkPolyData* body();
  vtkRenderer* renderer();
  vtkContactScene* scene();
  vtkRegimeMap* map();
  ComparisonChart& chart() { return this->Chart; }
  const RegimeStatement& statement() const { return this->Statement; }

private:
  std::string followContact(
    vtkIdType cell, const double contact[3], double deflection, double normalForce);
  std::string judge(vtkIdType point);
  std::string makeMap();
  void fitArrow();

  vtkSmartPointer<vtkPolyData> Body;
  std::vector<ComparedTool> Tools;
  ComparedMaterial Material;
  double Deflection = 1.0;
  std::size_t ShownTool = 0;
  /// Point of the statement; -1 if there is no statement or it is outdated.
  vtkIdType JudgedPoint = -1;
  RegimeStatement Statement;
  double ArrowForce = 0.0; ///< N, force to which the scale of the arrow is adapted

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkContactScene> Scene;
  vtkSmartPointer<vtkRegimeMap> Map;
  bool MapIsMade = false;
  vtkSmartPointer<vtkTextActor> Title;
  ComparisonChart Chart;
  VerdictPanel Panel;
};
} // namespace palpate

#endif
