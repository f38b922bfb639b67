// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkElasticContactResponse
 * @brief response of a tool on a body's true shape, with inclusions, by finite elements
 *
 * Input: a vtkUnstructuredGrid as in vtkElasticCompliance: VTK_HEXAHEDRON, VTK_VOXEL, VTK_TETRA and
 * VTK_QUADRATIC_TETRA cells in mm with the point array `Fixed` (bits 1, 2, 4 hold a point along x,
 * y, z). E and ν per cell come from arrays to process 0 and 1 (cell data, one component), else from
 * the constants. If there is a point array `Pressed`, only points where it is not 0 are solved for
 * and have responses. A fault of the input is an error that names cell and value. Empty input gives
 * empty output.
 *
 * Output: the body's outer surface as triangles, with the input's point arrays, `OriginalPointIds`,
 * and the response arrays of vtkToolContactResponse, for Tool pressed along the inward normal at
 * each point, unilateral and without friction, on a linear elastic body. `Range` is the smaller of
 * MaximumDeflection and the depth at which the contact reaches an edge (the surface turns by more
 * than 40°), a held point or another material at the surface. `Status` 5 Edge: no contact exists
 * before such a limit, or the surface turns by 30° at the point itself. The curve is then that of
 * the neighbouring points, reduced by the softening of the edge, with an error of about 15 %; its
 * validity is 0. Points of status 4 OutOfReach (held or not `Pressed`) and 1 Degenerate have no
 * curve. `Validity` and `Limit` follow from the estimated error. Values of `Limit`: 1 small strain;
 * 5 the effect of a nearby edge, except for its tilt; 7 the elements (the error expected from the
 * length of the cells, and from a second mesh) and the order of the kernel.
 *
 * The settings of the material, of strain, error, edges, tilt and relaxation are those of
 * vtkTissueFilter and vtkResponseFilter. With small strain the neglected effect of finite strain is
 * an error with the value 1 of `Limit`. A law of finite strain multiplies the local part of a
 * contact, as on a half-space under the same force; the remaining deflection of the body grows with
 * the force. With an ErrorTolerance of 0 no error is stored, and Validity is equal to Range.
 * Relaxation is that of the whole body.
 *
 * **AutomaticTerms**: the curve of a simpler law is kept, point by point, if true shape changes the
 * force by no more than TermTolerance. The law is a half-space of the material at the point with
 * the curvature of the surface, or a layer of LayerThickness (or of array to process 2, point data,
 * one component) on a rigid base. The point array `<name>ShapeChange` (float) is then the largest
 * relative change of the force by true shape (NaN: not known). TermReason gives the number of
 * points with each curve.
 *
 * **Method.** G_nn(x, X) = 1/(πE*|x-X|) + H(x, X): Boussinesq's field is subtracted, and the
 * elements solve for the smooth remainder (palpate::RegularGreen). H, averaged over angles on a
 * disc under the contact, is a kernel of rank up to four. With this kernel, dimensionality
 * reduction gives the contact in closed form for any radius and any tool of revolution. The sag of
 * the surface is a gap, and the tilt next to an edge is a second-order term
 * (palpate::ShapedContact). Between the solved places kernels are converted to the normal of each
 * place (palpate::DirectedCompliance).
 *
 * **Accuracy.** The force is within 1 % of the exact law on bonded layers up to contact radii of
 * 1.5 thicknesses with two hexahedra through the thickness, 0.35 % with four; within 1 % next to an
 * edge up to four fifths of its distance; within 5 % on nodules in voxels of half the nodule's
 * depth. Elements may be larger than the contact, but should be no larger than half the distance to
 * the source of H: a base, an edge, the top of a nodule. Linear tetrahedra lock: do not use them
 * beyond ν = 0.4.
 *
 * **Cost.** One factorisation (8 s for 100 thousand unknowns) and one solution per point of the
 * surface, or per SourceSpacing, 10 to 50 ms of one thread each, on all threads. The body and its H
 * are kept until the input, the material or the solver changes, or a tool has a wider contact;
 * otherwise the next tool takes a few milliseconds per point. Memory: the factor, which is refused
 * beforehand if it exceeds MemoryLimit, and H, a few hundred bytes per pair of points within a
 * contact. Abort is checked between steps and solutions. The result is bit-identical for any number
 * of threads.
 *
 * @code{.py}
 * felt = palpate.vtkElasticContactResponse()
 * felt.SetInputConnection(solid.GetOutputPort())       # vtkGradedBody or vtkVoxelBody
 * felt.SetTool(tool)
 * felt.SetYoungsModulus(0.05)                          # MPa
 * felt.SetMaximumDeflection(1.0)                       # mm
 * felt.SetSourceSpacing(3.0)                           # mm
 * felt.Update()
 * @endcode
 *
 * @sa vtkElasticCompliance vtkToolContactResponse vtkVoxelBody
 */
#ifndef vtkElasticContactResponse_h
#define vtkElasticContactResponse_h

#include "palpateSolidResponseModule.h" // For export macro
#include "vtkResponseFilter.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkAlgorithmOutput;
class vtkFloatArray;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace palpate
{
class CoarserBody;
class SolvedBody;
class SoundBody;
struct LawRequest;
struct SolveRequest;
struct ResponseStorage;
} // namespace palpate

class PALPATESOLIDRESPONSE_EXPORT vtkElasticContactResponse : public vtkResponseFilter
{
public:
  static vtkElasticContactResponse* New();
  vtkTypeMacro(vtkElasticContactResponse, vtkResponseFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The surface that is touched, if it is finer than the solid's own surface, for example a scan:
   * a vtkPolyData of triangles, mm, close to the surface of the solid. The output is then this
   * surface with its arrays. H at each of its points comes from the six nearest solved points that
   * face the same way (a plane through their values). The gap under the tool follows the shape of
   * this surface, which may be uneven (palpate::SurfaceGap, palpate::UnevenContact) and is
   * interpolated smoothly between its points. Detail between the points is an error of the surface,
   * not of the contact: the point array `<name>SurfaceError` (float) is the relative change of the
   * force at the end of the range that this detail may cause, in 95 of 100 cases. A warning is
   * given if this change exceeds ErrorTolerance at a tenth of the points. Optional; must not be
   * used with AutomaticTerms. */
  void SetSurfaceConnection(vtkAlgorithmOutput* output);
  void SetSurfaceData(vtkPolyData* surface);
  ///@}

  ///@{
  /** The same body in coarser cells, 1.5 to 2 times as long at the surface, held in the same places
   * and with the same arrays: a vtkUnstructuredGrid as the input. The difference of the two meshes
   * is then a second estimate of the error due to the length of the cells
   * (palpate::MeshDifference), in addition to the error expected from that length. If the cells
   * represent the shape of the body well, the stated error becomes several times smaller. The
   * forces do not change. These are errors: the grid has no cells, its extent differs from that of
   * the body, or its cells are not longer. The coarser body needs its own factor and solutions,
   * which cost a sixth of those of the body if its cells are twice as long. Optional. */
  void SetCoarserConnection(vtkAlgorithmOutput* output);
  void SetCoarserData(vtkUnstructuredGrid* coarser);
  ///@}

  ///@{
  /** Whether the output holds the motion of the body in addition to the tool's dent, for
   * vtkContactDeflection and the display, 120 bytes per point. The arrays are the motion of the
   * whole body (`GlobalMode0`... `GlobalMode5`, `GlobalModeSign`, as in vtkElasticCompliance), and
   * around each point the regular part H due to an edge, a base or a nodule near the point
   * (`NearField`, float 12, of palpate::NearField: the slope g in 1/N and R₀ in mm/N; the bend Q in
   * 1/(N mm), xx yy zz, and ρ in mm; xy yz zx, and E* in MPa). This costs 48 more solutions, once
   * for all tools. Default on. */
  vtkSetMacro(StoreMotion, bool);
  vtkGetMacro(StoreMotion, bool);
  vtkBooleanMacro(StoreMotion, bool);
  ///@}

  ///@{
  /** The largest contact radius that is solved for, mm. If it is set to the radius of the widest
   * contact of several tools, these tools share the solutions. 0 (default): 1.42 times that of Tool
   * at MaximumDeflection on a half-space. */
  vtkSetMacro(LargestContactRadius, double);
  vtkGetMacro(LargestContactRadius, double);
  ///@}

  ///@{
  /** Distance between the surface points for which the body is solved, mm; it is smaller near
   * edges. At other points H is interpolated from the solved points around them, so that all points
   * have responses. Half the distance to the source of H (a base, a nodule) is enough. 0 (default):
   * that of the input's field array `SourceSpacing`, which vtkSegmentedBody adds, else all points.
   */
  vtkSetMacro(SourceSpacing, double);
  vtkGetMacro(SourceSpacing, double);
  ///@}

  ///@{
  /** As in vtkElasticCompliance: MiB, 0 (default): nine tenths of the available memory. */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /** As in vtkElasticCompliance: 0 Automatic (default), 1 Supernodal, 2 Simplicial. */
  vtkSetMacro(Solver, int);
  vtkGetMacro(Solver, int);
  ///@}

  /** Estimated memory of the factorisation and the solutions of the last run, MiB; also set if the
   * run was refused; 0 if nothing had to be computed. */
  vtkGetMacro(MemoryEstimate, double);
  /**
   * Number of surface points for which the last run solved the body; 0 if nothing had to be solved.
   */
  vtkGetMacro(NumberOfSolutions, vtkIdType);

protected:
  vtkElasticContactResponse();
  ~vtkElasticContactResponse() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkElasticContactResponse(const vtkElasticContactResponse&) = delete;
  void operator=(const vtkElasticContactResponse&) = delete;

  std::string CheckProperties(palpate::LawRequest& request);
  std::string FindMaterials(vtkUnstructuredGrid* grid, palpate::SolveRequest& request);
  std::string Solve(vtkUnstructuredGrid* grid, vtkUnstructuredGrid* coarser, bool& ended);
  void WarnOfSurface(vtkFloatArray* error);
  std::string KeepSimplerLaw(vtkPolyData* surface, palpate::ResponseStorage& storage);
  std::string CheckSurface(const palpate::SoundBody& finer) const;
  std::string Respond(const palpate::LawRequest& request, vtkUnstructuredGrid* grid,
    vtkPolyData* finer, vtkPolyData* output);

  std::unique_ptr<palpate::SolvedBody> Kept;
  std::unique_ptr<palpate::CoarserBody> Coarser; ///< null: no coarser body
  bool StoreMotion = true;
  double LargestContactRadius = 0.0;
  double SourceSpacing = 0.0;
  std::string ThicknessName; ///< name of the array to process 2 in the last run
  double MemoryLimit = 0.0;
  int Solver = 0;
  double MemoryEstimate = 0.0;
  vtkIdType NumberOfSolutions = 0;
};

#endif
