// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkElasticContactResponse
 * @brief computes the response of a tool on a body's true shape, with inclusions, by finite
 *   elements
 *
 * Input: a vtkUnstructuredGrid as in vtkElasticCompliance: VTK_HEXAHEDRON, VTK_VOXEL, VTK_TETRA and
 * VTK_QUADRATIC_TETRA cells in mm with the point array `Fixed` (bits 1, 2, 4 hold a point along x,
 * y, z). E and ν per cell are taken from the arrays to process 0 and 1 (cell data, one component),
 * else from the constants. If there is a point array `Pressed`, the body is solved only for the
 * points where the array is not 0, and only these points have responses. Invalid input raises an
 * error that names cell and value. Empty input gives empty output.
 *
 * Output: the body's outer surface as triangles, with the input's point arrays, `OriginalPointIds`,
 * and the response arrays of vtkToolContactResponse. They describe Tool pressed along the inward
 * normal at each point on a linear elastic body, in a unilateral contact without friction. `Range`
 * is the smaller of MaximumDeflection and the depth at which the contact reaches an edge (the
 * normal of the surface varies by more than 40°), a held point or another material at the surface.
 * The `Status` is 5 Edge if these limits allow no contact at all, or if the normal of the surface
 * varies by 30° at the point itself. The curve is then that of the neighbouring points, reduced by
 * the softening of the edge, with an error of about 15 %, and its validity is 0. Points of status 4
 * OutOfReach (held or not `Pressed`) and 1 Degenerate have no curve. `Validity` and `Limit` follow
 * from the estimated error. Values of `Limit`: 1 small strain; 5 the effect of a nearby edge,
 * except for its tilt; 7 the elements (the error expected from the length of the cells, and from a
 * second mesh) and the order of the kernel.
 *
 * The settings of material, strain, error, edges, tilt and relaxation are those of vtkTissueFilter
 * and vtkResponseFilter. With small strain, the neglected effect of finite strain is part of the
 * error, with the value 1 of `Limit`. A law of finite strain multiplies the local part of a
 * contact, as on a half-space under the same force. The remaining deflection of the body grows with
 * the force. With an ErrorTolerance of 0, no error is stored, and Validity is equal to Range.
 * Relaxation applies to the whole body.
 *
 * **AutomaticTerms**: at each point, the curve of a simpler law is kept if the true shape changes
 * the force by no more than TermTolerance. The simpler law is that of a half-space with the
 * material at the point and the curvature of the surface, or that of a layer on a rigid base. The
 * thickness of the layer is LayerThickness or the array to process 2 (point data, one component).
 * The point array `<name>ShapeChange` (float) contains the largest relative change of the force by
 * the true shape, or NaN if it is not known. TermReason gives the number of points with each curve.
 *
 * **Method.** The Green function is G_nn(x, X) = 1/(πE*|x-X|) + H(x, X). Boussinesq's field, the
 * first term, is subtracted, and the finite elements solve for the smooth remainder H
 * (palpate::RegularGreen). H, averaged over angles on a disc under the contact, is a kernel of rank
 * up to four. With this kernel, dimensionality reduction gives the contact in closed form for any
 * radius and any tool of revolution. The sag of the surface is added to the gap under the tool, and
 * the tilt of the surface next to an edge is a second-order term (palpate::ShapedContact). Kernels
 * between the solved points are converted to the normal of the point where they are used
 * (palpate::DirectedCompliance).
 *
 * **Accuracy.** On bonded layers, for contact radii up to 1.5 thicknesses, the force is within 1 %
 * of the exact law with two hexahedra through the thickness, and within 0.35 % with four. Next to
 * an edge, it is within 1 % for contact radii up to four fifths of the distance from the edge. On
 * nodules, it is within 5 % with voxels of half the nodule's depth. Elements may be larger than the
 * contact, but should be no larger than half the distance to the cause of H, such as a base, an
 * edge or the top of a nodule. Linear tetrahedra lock. Do not use them beyond ν = 0.4.
 *
 * **Cost.** One factorisation takes 8 s for 100 thousand unknowns. There is one solution per point
 * of the surface, or per SourceSpacing. Each takes 10 to 50 ms on one thread, and all threads are
 * used. The body and its H are kept until the input, the material or the solver changes, or until a
 * tool has a wider contact. As long as they are kept, the next tool takes a few milliseconds per
 * point. The factor takes most of the memory; if it would exceed MemoryLimit, the body is refused
 * before factorisation. H takes a few hundred bytes per pair of points within a contact. Abort is
 * checked between steps and solutions. The result is bit-identical for any number of threads.
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
  /**
   * The touched surface, if it is finer than the surface of the solid, for example a scan. It is a
   * vtkPolyData of triangles, mm, close to the surface of the solid. The output is then this
   * surface with its arrays. H at each of its points is interpolated from the six nearest solved
   * points with a similar normal (a plane fitted to their values). The gap under the tool follows
   * the shape of this surface, which may be uneven (palpate::SurfaceGap, palpate::UnevenContact)
   * and is interpolated smoothly between its points. Unresolved detail between the points causes an
   * error of the surface, not of the contact. The point array `<name>SurfaceError` (float) is the
   * relative change of the force at the end of the range due to this detail, which is not exceeded
   * in 95 of 100 cases. A warning is given if this change exceeds ErrorTolerance at a tenth of the
   * points. The surface is optional and must not be used with AutomaticTerms.
   */
  void SetSurfaceConnection(vtkAlgorithmOutput* output);
  void SetSurfaceData(vtkPolyData* surface);
  ///@}

  ///@{
  /** The same body with coarser cells, as a vtkUnstructuredGrid like the input. Its cells are 1.5
   * to 2 times as long at the surface. It is held in the same places and has the same arrays. The
   * difference of the two meshes gives a second estimate of the error due to the length of the
   * cells (palpate::MeshDifference), in addition to the error that is expected from this length. If
   * the cells represent the shape of the body well, the stated error becomes several times smaller.
   * The forces do not change. These are errors: the grid has no cells, its extent differs from that
   * of the body, or its cells are not longer. The coarser body needs its own factor and solutions.
   * They cost a sixth of those of the body if the cells of the coarser body are twice as long. The
   * coarser body is optional. */
  void SetCoarserConnection(vtkAlgorithmOutput* output);
  void SetCoarserData(vtkUnstructuredGrid* coarser);
  ///@}

  ///@{
  /**
   * Whether the output contains the motion of the body in addition to the tool's dent, for
   * vtkContactDeflection and the display. It takes 120 bytes per point. The motion of the whole
   * body is stored in the arrays `GlobalMode0`... `GlobalMode5` and `GlobalModeSign`, as in
   * vtkElasticCompliance. The array `NearField` (float 12) describes the regular part H around each
   * point, due to an edge, a base or a nodule near the point. It contains the numbers of
   * palpate::NearField: the slope g in 1/N and R₀ in mm/N; the components xx, yy, zz of the bend Q
   * in 1/(N mm), and ρ in mm; the components xy, yz, zx of Q, and E* in MPa. The motion takes 48
   * more solutions, once for all tools. Default on.
   */
  vtkSetMacro(StoreMotion, bool);
  vtkGetMacro(StoreMotion, bool);
  vtkBooleanMacro(StoreMotion, bool);
  ///@}

  ///@{
  /**
   * The largest contact radius for which the body is solved, mm. If it is set to the radius of the
   * widest contact of several tools, these tools share the solutions. The default 0 selects 1.42
   * times the contact radius of Tool at MaximumDeflection on a half-space.
   */
  vtkSetMacro(LargestContactRadius, double);
  vtkGetMacro(LargestContactRadius, double);
  ///@}

  ///@{
  /** Distance between the surface points for which the body is solved, mm; it is smaller near
   * edges. At other points H is interpolated from the solved points around them, so that all points
   * have responses. Half the distance to the cause of H (a base, a nodule) is sufficient. The
   * default 0 selects the value of the input's field array `SourceSpacing`, which vtkSegmentedBody
   * adds. If the input has no such array, the body is solved for all points.
   */
  vtkSetMacro(SourceSpacing, double);
  vtkGetMacro(SourceSpacing, double);
  ///@}

  ///@{
  /**
   * Same as in vtkElasticCompliance, MiB. The default 0 allows nine tenths of the available memory.
   */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  ///@{
  /** Same as in vtkElasticCompliance: 0 Automatic (default), 1 Supernodal, 2 Simplicial. */
  vtkSetMacro(Solver, int);
  vtkGetMacro(Solver, int);
  ///@}

  /**
   * Estimated memory of the factorisation and the solutions of the last run, MiB. It is also set if
   * the run was refused, and 0 if nothing had to be computed.
   */
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
  std::unique_ptr<palpate::CoarserBody> Coarser; ///< null if there is no coarser body
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
