package org.phrenic.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.mesh.voxel.VoxelBox;
import org.phrenic.simulation.SceneSurfaces;
import org.phrenic.simulation.Simulation;
import org.phrenic.simulation.observe.Surface;

/**
 * Where every point of a body goes: its displacement from rest at end-expiration to the present state of a simulation,
 * mm, LPS. The body is divided into regions by its surfaces ({@link BodyRegions}):
 *
 * <ul>
 *   <li>inside bones the motion is that of the bone, rigid;
 *   <li>inside every other closed surface it extends that of the surface ({@link HarmonicExtension}), or in lungs,
 *       where asked for, is that of a {@link SlidingElasticSolid};
 *   <li>the soft tissue of the wall, and that of the abdomen below the diaphragm, extend what moves within them and
 *       slide along lungs and diaphragm ({@link SoftTissue});
 *   <li>outside the skin the motion of the wall fades to 0 within {@value #OUTSIDE_MM} mm.
 * </ul>
 *
 * <p>On the surfaces the motion is that of the simulation, vertex by vertex; within a triangle it is linear. The fields
 * that are made for images leave that last correction out; {@link #latticeError} measures it.
 *
 * <p>Not thread-safe. The same state gives the same bits on any number of threads.
 */
public final class BodyMotion implements AutoCloseable {
    /** Distance outside the skin from which on nothing moves, mm. */
    public static final int OUTSIDE_MM = 84;
    /** Points nearer to a surface than this belong to it, mm. */
    private static final double ON_SURFACE_MM = 1e-6;

    private final SceneSurfaces scene;
    private final List<Surface> surfaces;
    private final BodyRegions regions;
    private final ClosedRegion[] closed;
    private final SoftTissue wall;
    private final SoftTissue abdomen;
    private final TriangleTree[] trees;
    private final Workers workers;
    private List<double[]> positions;
    private final RigidField[] rigid;

    /**
     * Divides a body into regions. The simulation must be at rest.
     *
     * @param lungs what moves the inside of lungs
     * @param organs whether the organs that the mechanical model leaves out are regions of their own
     */
    public BodyMotion(Simulation simulation, boolean organs, LungInside lungs, int threads) {
        scene = organs ? SceneSurfaces.withOrgans(simulation) : new SceneSurfaces(simulation);
        surfaces = scene.surfaces();
        regions = new BodyRegions(surfaces, simulation.scene().diaphragm().diaphragm);
        workers = Workers.of(threads);
        closed = new ClosedRegion[surfaces.size()];
        rigid = new RigidField[surfaces.size()];
        trees = new TriangleTree[surfaces.size()];
        workers.run(closed.length, i -> {
            trees[i] = new TriangleTree(surfaces.get(i).rest());
            if (regions.isRegion(i) && surfaces.get(i).motion() == Surface.Motion.DEFORMING) {
                boolean elastic = lungs == LungInside.ELASTIC && surfaces.get(i).kind() == StructureKind.LUNG;
                closed[i] = new ClosedRegion(surfaces.get(i), elastic);
            }
        });
        SoftTissue[] soft = SoftTissue.of(surfaces, regions);
        wall = soft[0];
        abdomen = soft[1];
        update();
    }

    /** Takes the present state of the simulation. */
    public void update() {
        positions = scene.meshes().stream().map(TriangleMesh::positions).toList();
        double[] still = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        for (int i = 0; i < rigid.length; i++) {
            boolean moving = surfaces.get(i).motion() == Surface.Motion.RIGID;
            rigid[i] = new RigidField(moving ? scene.pose(i) : still);
        }
        // The wall and the lungs take longest and are begun first.
        workers.run(closed.length + 1, piece -> {
            if (piece == 0) {
                wall.update(positions, wall.lattice());
            } else if (closed[closed.length - piece] != null) {
                closed[closed.length - piece].update(positions.get(closed.length - piece));
            }
        });
        abdomen.update(positions, wall.lattice());
    }

    /** The surfaces that divide the body. */
    public List<Surface> surfaces() {
        return surfaces;
    }

    /** Present positions of the vertices of a surface, mm; shared. */
    public double[] positions(int surface) {
        return positions.get(surface);
    }

    /**
     * Number of a structure for {@link #moved}.
     *
     * @throws BadInputException if the body has no such structure
     */
    public int structure(String name) {
        String usual = StructureName.usual(name);
        for (int i = 0; i < surfaces.size(); i++) {
            if (surfaces.get(i).name().equalsIgnoreCase(usual)) {
                return i;
            }
        }
        throw new BadInputException("found structure '" + name + "', expected one of "
                + String.join(", ", surfaces.stream().map(Surface::name).toList()));
    }

    /** The closed surface that a place at rest is in or on; empty for soft tissue and outside. */
    public Optional<Integer> structureAt(double x, double y, double z) {
        int[] order = regions.order();
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (int n = order.length - 1; n >= 0; n--) {
            double[] box = surfaces.get(order[n]).rest().bounds();
            if (BoundingBoxes.squaredDistance(box, 0, x, y, z) > ON_SURFACE_MM * ON_SURFACE_MM) {
                continue;
            }
            if (trees[order[n]].isInside(x, y, z) || trees[order[n]].closest(x, y, z, ON_SURFACE_MM, hit)) {
                return Optional.of(order[n]);
            }
        }
        return Optional.empty();
    }

    /** Where a point at rest is now: it moves with the closed surface that it is in, or with the soft tissue. */
    public double[] moved(double[] place) {
        Optional<Integer> inside = structureAt(place[0], place[1], place[2]);
        return inside.isPresent() ? moved(inside.get(), place) : moved(exactSoft(place), place);
    }

    /** Where a point is now that belongs to a structure, wherever it lies; of skin and pleura, to the wall. */
    public double[] moved(int structure, double[] place) {
        return moved(exact(structure), place);
    }

    private static double[] moved(RegionField field, double[] place) {
        double[] u = new double[3];
        field.at(place[0], place[1], place[2], u);
        return new double[] {place[0] + u[0], place[1] + u[1], place[2] + u[2]};
    }

    private RegionField exact(int surface) {
        if (!regions.isRegion(surface)) {
            return regions.moves(surface, BodyRegions.WALL) ? wall.exact() : abdomen.exact();
        }
        return closed[surface] == null ? rigid[surface] : closed[surface].exact();
    }

    private RegionField exactSoft(double[] place) {
        return regionAt(place) == BodyRegions.ABDOMEN ? abdomen.exact() : wall.exact();
    }

    /** The region of a place at rest. */
    private int regionAt(double[] place) {
        double[] corner = {1, 0, 0, place[0], 0, 1, 0, place[1], 0, 0, 1, place[2]};
        return Byte.toUnsignedInt(regions.label(new VoxelBox(new int[] {1, 1, 1}, corner), rest())[0]);
    }

    /** Names of the regions, from number 0 on: outside, wall, abdomen, then the surfaces. */
    public List<String> regionNames() {
        List<String> names = new ArrayList<>(List.of("outside", "wall", "abdomen"));
        surfaces.forEach(s -> names.add(s.name()));
        return names;
    }

    /** The soft tissue of a place at rest that is in no closed surface: "wall", "abdomen" or "outside". */
    public String softTissueAt(double[] place) {
        return switch (regionAt(place)) {
            case BodyRegions.OUTSIDE -> "outside";
            case BodyRegions.ABDOMEN -> "abdomen";
            default -> "wall";
        };
    }

    /** Box of the body at rest: three least, three greatest coordinates, mm. */
    public double[] bounds() {
        return Surface.bounds(surfaces);
    }

    BodyRegions regions() {
        return regions;
    }

    Workers workers() {
        return workers;
    }

    /** Positions of the vertices of all surfaces at rest. */
    List<double[]> rest() {
        return surfaces.stream().map(s -> s.rest().positions()).toList();
    }

    /** Present positions of the vertices of all surfaces. */
    List<double[]> now() {
        return positions;
    }

    /** The displacement of a region for images. */
    RegionField field(int region) {
        if (region <= BodyRegions.WALL) {
            return wall.lattice();
        }
        if (region == BodyRegions.ABDOMEN) {
            return abdomen.lattice();
        }
        int surface = region - BodyRegions.FIRST;
        return closed[surface] == null ? rigid[surface] : closed[surface].lattice();
    }

    /**
     * Distance of the fields for images from the vertices of the surfaces, mm: mean, 99th percentile, greatest.
     * Vertices along which an elastic lung slides do not count.
     */
    public double[] latticeError() {
        List<Double> errors = new ArrayList<>();
        double[] u = new double[3];
        for (int i = 0; i < closed.length; i++) {
            double[] p = surfaces.get(i).rest().positions();
            boolean held = closed[i] != null && !closed[i].isElastic();
            for (int k = 0; k < p.length && held; k += 3) {
                closed[i].lattice().at(p[k], p[k + 1], p[k + 2], u);
                double square = 0;
                for (int axis = 0; axis < 3; axis++) {
                    double d = p[k + axis] + u[axis] - positions.get(i)[k + axis];
                    square += d * d;
                }
                errors.add(Math.sqrt(square));
            }
        }
        double[] sorted =
                errors.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        return sorted.length == 0
                ? new double[3]
                : new double[] {
                    Arrays.stream(sorted).average().orElse(0),
                    sorted[(int) (0.99 * (sorted.length - 1))],
                    sorted[sorted.length - 1]
                };
    }

    /** Ends the worker threads. */
    @Override
    public void close() {
        workers.close();
    }
}
