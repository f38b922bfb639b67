// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkElasticContactResponse
 * @brief what a tool feels on a body's true shape, and on what lies in it, by finite elements
 *
 * Input: a vtkUnstructuredGrid as of vtkElasticCompliance: VTK_HEXAHEDRON, VTK_VOXEL, VTK_TETRA and
 * VTK_QUADRATIC_TETRA cells in mm with the point array `Fixed` (bits 1, 2, 4 hold a point along x,
 * y, z), E and ν per cell by arrays to process 0 and 1 (cell data, one component), else the
 * constants. With a point array `Pressed` there are responses only where that is not 0, and no
 * solutions for others. What is wrong with it is an error that names cell and value. Empty input
 * gives empty output.
 *
 * Output: the body's outer surface as triangles, with the input's point arrays,
 * `OriginalPointIds`, and the response arrays of vtkToolContactResponse, as they are for Tool
 * pressed along the inward normal at each point, unilateral and without friction, the body linear
 * elastic. `Range` is the least of MaximumDeflection and the depth at which the contact reaches an
 * edge (the surface turns by more than 40°), a held point or another material at the surface.
 * `Status` 5 Edge where there is no contact before, or the surface turns by 30° at the point
 * itself: the curve is taken from the points around, as much softer as the edge is, within some
 * 15 %, its validity 0; 4 OutOfReach where the point is held or not `Pressed`, 1 Degenerate: no
 * curve. `Validity` and `Limit` by the estimated error: 1 small strain, 5 what an edge nearby does
 * beyond its tilt, 7 the elements (what cells of their length let expect, and what a second mesh
 * tells) and the order of the kernel.
 *
 * **Method.** G_nn(x, X) = 1/(πE*|x-X|) + H(x, X): Boussinesq's field is subtracted, the elements
 * solve for what is left, which is smooth (palpate::RegularGreen). H, averaged over angles on a
 * disc that follows the contact, is a kernel of rank up to four, whose contact of any radius and
 * tool of revolution is explicit by dimensionality reduction; the drop of the surface is a gap, the
 * tilt next to an edge a second-order term (palpate::ShapedContact). Between the places that are
 * solved for kernels are turned to the normal of each (palpate::DirectedCompliance).
 *
 * **Accuracy.** Within 1 % of the exact law on bonded layers to contact radii of one and a half
 * thicknesses with two hexahedra through it, 0.35 % with four; within 1 % next to an edge to four
 * fifths of its distance; 5 % on nodules on voxels of half their depth. Elements may be larger than
 * the contact, but should be no larger than half the distance to what makes the difference: a base,
 * an edge, the top of a nodule. Linear tetrahedra lock: not beyond ν = 0.4.
 *
 * **Cost.** One factorisation (8 s for 100 thousand unknowns) and one solution per point of the
 * surface, or per SourceSpacing, 10 to 50 ms of one thread each, on all threads. The body and its H
 * are kept until the input, the material or the solver changes, or a contact gets wider: the next
 * tool takes some milliseconds per point. Memory: that of the factor, refused beforehand if beyond
 * MemoryLimit, and of H, some hundred bytes per pair of points within a contact. Abort is seen
 * between steps and solutions. The same bits for any number of threads.
 *
 * @sa vtkElasticCompliance vtkToolContactResponse vtkVoxelBody
 */
#ifndef vtkElasticContactResponse_h
#define vtkElasticContactResponse_h

#include "Response/Curves/RelaxationList.h" // For palpate::RelaxationList
#include "palpateSolidResponseModule.h"     // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkAlgorithmOutput;
class vtkContactTool;
class vtkFloatArray;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace palpate
{
class CoarserBody;
class SolvedBody;
class SoundBody;
struct SolveRequest;
struct ResponseStorage;
} // namespace palpate

class PALPATESOLIDRESPONSE_EXPORT vtkElasticContactResponse : public vtkPolyDataAlgorithm
{
public:
  static vtkElasticContactResponse* New();
  vtkTypeMacro(vtkElasticContactResponse, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The surface that is to be touched, where that is finer than the solid's own, as a scan is: a
   * vtkPolyData of triangles, mm, beside the solid's. The output is then that surface with its
   * arrays: at each of its points H is that of the six solved ones around that face the same way
   * (a plane through their values), and the gap under the tool is its own shape there, whatever it
   * is (palpate::SurfaceGap, palpate::UnevenContact), smooth between its points. What may lie
   * between them is the surface's error, not the contact's: the point array `<name>SurfaceError`
   * (float) tells by how much it may change the force at the end of the range, relative, in 95 of
   * 100 cases; there is a warning where that is more than ErrorTolerance at a tenth of the points.
   * Optional; not with AutomaticTerms. */
  void SetSurfaceConnection(vtkAlgorithmOutput* output);
  void SetSurfaceData(vtkPolyData* surface);
  ///@}

  ///@{
  /** The same body in coarser cells, one and a half to twice as long at the surface, held in the
   * same places and with the same arrays: a vtkUnstructuredGrid as the input. How far the two
   * meshes differ then tells, beside what cells of that length let expect, what their length does
   * to the force (palpate::MeshDifference): its stated error is several times narrower on bodies
   * that the cells follow well. The forces are the same. One with no cells, of another extent than
   * the body, or with cells that are not longer, is an error. Costs its own factor and solutions, a
   * sixth of the body's where its cells are twice as long. Optional. */
  void SetCoarserConnection(vtkAlgorithmOutput* output);
  void SetCoarserData(vtkUnstructuredGrid* coarser);
  ///@}

  ///@{
  /** The tool; required. Its changes count in this filter's modification time. */
  virtual void SetTool(vtkContactTool* tool);
  vtkContactTool* GetTool();
  ///@}

  ///@{
  /** As of vtkElasticCompliance: E, MPa, of cells without an array. Default 0.1. */
  vtkSetMacro(YoungsModulus, double);
  vtkGetMacro(YoungsModulus, double);
  ///@}

  ///@{
  /** As of vtkElasticCompliance: 0 to 0.499, of cells without an array. Default 0.45. */
  vtkSetMacro(PoissonRatio, double);
  vtkGetMacro(PoissonRatio, double);
  ///@}

  ///@{
  /** As of vtkToolContactResponse: 2 mm, 8, "Response". */
  vtkSetMacro(MaximumDeflection, double);
  vtkGetMacro(MaximumDeflection, double);
  vtkSetMacro(NumberOfSamples, int);
  vtkGetMacro(NumberOfSamples, int);
  vtkSetMacro(ResponseName, std::string);
  vtkGetMacro(ResponseName, std::string);
  ///@}

  ///@{
  /** As of vtkToolContactResponse: 0.05, and on. With a tolerance of 0 there is no error, and
   * Validity is Range. */
  vtkSetMacro(ErrorTolerance, double);
  vtkGetMacro(ErrorTolerance, double);
  vtkSetMacro(StoreError, bool);
  vtkGetMacro(StoreError, bool);
  vtkBooleanMacro(StoreError, bool);
  ///@}

  ///@{
  /** Whether the output tells vtkContactDeflection and the display how the body moves besides the
   * tool's dent, 120 bytes a point: as a whole (`GlobalMode0`... `GlobalMode5`, `GlobalModeSign`,
   * as of vtkElasticCompliance), and around each point what these leave of H, an edge, a base or a
   * nodule near it (`NearField`, float 12, of palpate::NearField: the slope g in 1/N and R₀ in
   * mm/N; the bend Q in 1/(N mm), xx yy zz, and ρ in mm; xy yz zx, and E* in MPa). Costs 48 more
   * solutions, once for all tools. Default on. */
  vtkSetMacro(StoreMotion, bool);
  vtkGetMacro(StoreMotion, bool);
  vtkBooleanMacro(StoreMotion, bool);
  ///@}

  ///@{
  /** The widest contact that is solved for, mm: set to that of the widest of several tools, they
   * share the solutions. 0 (default): 1.42 times that of Tool at MaximumDeflection on a half-space.
   */
  vtkSetMacro(LargestContactRadius, double);
  vtkGetMacro(LargestContactRadius, double);
  ///@}

  ///@{
  /** Distance of the points of the surface that are solved for, mm: closer together towards edges;
   * what lies between takes H from those around, so that all points have responses. Half the
   * distance to what makes a difference (a base, a nodule) is enough. 0 (default): all points. */
  vtkSetMacro(SourceSpacing, double);
  vtkGetMacro(SourceSpacing, double);
  ///@}

  /// Values of StrainModel.
  enum StrainModelType
  {
    SmallStrain = 0,
    NeoHooke = 1,
    Ogden = 2,
    Demiray = 3
  };

  ///@{
  /** As of vtkToolContactResponse: SmallStrain (default), what finite strain would change being
   * part 1 of `Limit`, or one of its laws. That multiplies what is local of a contact, as on a
   * half-space under the same force; what the body gives way otherwise grows with the force. */
  vtkSetClampMacro(StrainModel, int, SmallStrain, Demiray);
  vtkGetMacro(StrainModel, int);
  void SetStrainModelToSmallStrain() { this->SetStrainModel(SmallStrain); }
  void SetStrainModelToNeoHooke() { this->SetStrainModel(NeoHooke); }
  void SetStrainModelToOgden() { this->SetStrainModel(Ogden); }
  void SetStrainModelToDemiray() { this->SetStrainModel(Demiray); }
  vtkSetMacro(OgdenExponent, double);
  vtkGetMacro(OgdenExponent, double);
  vtkSetMacro(DemirayExponent, double);
  vtkGetMacro(DemirayExponent, double);
  ///@}

  ///@{
  /** Whether a contact leaves over sharp convex edges with its force going to nothing, as of
   * vtkToolContactResponse; that it is softer beside them is in the curves. Default off. */
  vtkSetMacro(EdgeCorrection, bool);
  vtkGetMacro(EdgeCorrection, bool);
  vtkBooleanMacro(EdgeCorrection, bool);
  ///@}

  ///@{
  /** How far the tool will be tilted, degrees, as of vtkToolContactResponse; the tilts are those of
   * a half-space, whatever the body's shape. Default 0: upright. */
  vtkSetMacro(MaximumTilt, double);
  vtkGetMacro(MaximumTilt, double);
  ///@}

  ///@{
  /**
   * How the body relaxes: E(t)/E∞ = 1 + Σ p exp(-t/τ), each branch with its strength p >= 0,
   * relative to the slow modulus E∞, and its time τ > 0 in seconds; up to four. As of
   * vtkToolContactResponse, of the whole body: the curves are the slow response. Default none.
   */
  void AddRelaxation(double strength, double seconds)
  {
    this->Relaxations.add(strength, seconds);
    this->Modified();
  }
  void ClearRelaxations()
  {
    if (this->Relaxations.clear())
    {
      this->Modified();
    }
  }
  int GetNumberOfRelaxations() { return this->Relaxations.count(); }
  double GetRelaxationStrength(int relaxation) { return this->Relaxations.strength(relaxation); }
  double GetRelaxationTime(int relaxation) { return this->Relaxations.seconds(relaxation); }
  ///@}

  ///@{
  /** Whether a simpler law's curve is kept where true shape changes the force by no more than
   * TermTolerance, point by point: that of a half-space of the material at the point, curved as the
   * surface is, or of a layer of LayerThickness on a rigid base. The point array
   * `<name>ShapeChange` (float) then tells by how much true shape changes the force, relative,
   * where it changes most (NaN: not known), and GetTermReason and the field array `<name>Terms` how
   * many points keep what. Default off. */
  vtkSetMacro(AutomaticTerms, bool);
  vtkGetMacro(AutomaticTerms, bool);
  vtkBooleanMacro(AutomaticTerms, bool);
  ///@}

  ///@{
  /** Change of the force, relative, that AutomaticTerms may leave out, >= 0. Default 0.01. */
  vtkSetMacro(TermTolerance, double);
  vtkGetMacro(TermTolerance, double);
  ///@}

  ///@{
  /** Thickness, mm, >= 0, of the layer that AutomaticTerms compares with, at points without an
   * array (array to process 2, point data, one component); 0 (default): a half-space. */
  vtkSetMacro(LayerThickness, double);
  vtkGetMacro(LayerThickness, double);
  ///@}

  /// Of the last run, what AutomaticTerms kept, in words; "" without it.
  vtkGetMacro(TermReason, std::string);

  ///@{
  /** As of vtkElasticCompliance: MiB, 0 (default): nine tenths of what is available. */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /** As of vtkElasticCompliance: 0 Automatic (default), 1 Supernodal, 2 Simplicial. */
  vtkSetMacro(Solver, int);
  vtkGetMacro(Solver, int);
  ///@}

  /** Estimated memory of what the last run factorised and solved, MiB; known also after that was
   * refused; 0: all that was needed was there. */
  vtkGetMacro(MemoryEstimate, double);
  /** How many points of the surface were solved for in the last run; 0: all that was needed was
   * there. */
  vtkGetMacro(NumberOfSolutions, vtkIdType);

  vtkMTimeType GetMTime() override;

protected:
  vtkElasticContactResponse();
  ~vtkElasticContactResponse() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkElasticContactResponse(const vtkElasticContactResponse&) = delete;
  void operator=(const vtkElasticContactResponse&) = delete;

  std::string CheckProperties();
  std::string FindMaterials(vtkUnstructuredGrid* grid, palpate::SolveRequest& request);
  std::string Solve(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* coarser, bool& ended);
  void WarnOfSurface(vtkFloatArray* error);
  std::string KeepSimplerLaw(vtkPolyData* surface, palpate::ResponseStorage& storage);
  std::string CheckSurface(const palpate::SoundBody& finer) const;
  std::string Respond(vtkUnstructuredGrid* grid, vtkPolyData* finer, vtkPolyData* output);

  std::unique_ptr<palpate::SolvedBody> Kept;
  std::unique_ptr<palpate::CoarserBody> Coarser; ///< null: there is none
  vtkSmartPointer<vtkContactTool> Tool;
  double YoungsModulus = 0.1;
  double PoissonRatio = 0.45;
  double MaximumDeflection = 2.0;
  int NumberOfSamples = 8;
  std::string ResponseName = "Response";
  double ErrorTolerance = 0.05;
  bool StoreError = true;
  bool StoreMotion = true;
  double LargestContactRadius = 0.0;
  double SourceSpacing = 0.0;
  bool EdgeCorrection = false;
  double MaximumTilt = 0.0;
  int StrainModel = SmallStrain;
  double OgdenExponent = 2.0;
  double DemirayExponent = 1.0;
  palpate::RelaxationList Relaxations;
  bool AutomaticTerms = false;
  double TermTolerance = 0.01;
  double LayerThickness = 0.0;
  std::string ThicknessName; ///< of the array to process 2 in the last run
  std::string TermReason;
  double MemoryLimit = 0.0;
  int Solver = 0;
  double MemoryEstimate = 0.0;
  vtkIdType NumberOfSolutions = 0;
};

#endif
