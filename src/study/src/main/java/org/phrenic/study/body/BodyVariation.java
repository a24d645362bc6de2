package org.phrenic.study.body;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.patient.diaphragm.CageEnvelope;

/**
 * Size and shape of a body relative to another, as smooth maps of its surfaces. Bones and organs are mapped alike, so
 * that what touches goes on touching; only the height of the domes changes soft organs alone.
 *
 * <p>In order: the domes are raised, the chest is made deeper about the front of the spine and its front is raised
 * (barrel), the spine is bent forward above the lowest rib (kyphosis), and all axes are scaled. Last, the diaphragm is
 * kept within the cage.
 *
 * @param scaleX factor from side to side
 * @param scaleY factor from front to back
 * @param scaleZ factor of the height
 * @param kyphosisDeg additional forward bend of the spine over the height of the ribs, degrees
 * @param barrel relative increase of the depth of the chest at its middle height; its ribs become more horizontal
 * @param domeLiftMm height by which both domes, liver and bases of the lungs are raised, mm
 */
public record BodyVariation(
        double scaleX, double scaleY, double scaleZ, double kyphosisDeg, double barrel, double domeLiftMm) {
    /** Least factor of an axis. */
    public static final double LEAST_SCALE = 0.8;
    /** Greatest factor of an axis. */
    public static final double MOST_SCALE = 1.25;
    /** Greatest additional bend of the spine, degrees. */
    public static final double MOST_KYPHOSIS_DEG = 25;
    /** Greatest relative increase of the depth of the chest. */
    public static final double MOST_BARREL = 0.25;
    /** Greatest lowering of the domes, mm, negative. */
    public static final double LOWEST_DOMES_MM = -15;
    /** Greatest rise of the domes, mm. */
    public static final double HIGHEST_DOMES_MM = 30;

    /** Rise of the sternum of a barrel chest, as a fraction of its distance from the spine and of the increase. */
    private static final double RISE = 0.5;
    /** Distance from the middle of the sheet, relative to its half-axes, from which on its domes are not raised. */
    private static final double WALL = 0.95;

    private static final double ROOF = 0.45;
    /** Height of the sheet above its lowest point below which nothing is raised, relative to its whole height. */
    private static final double FOOT = 0.35;

    /** Greatest distance of the sheet outside the inner envelope of the cage, mm. */
    private static final double OUTSIDE_MM = 2.5;

    private static final Set<StructureKind> SOFT = EnumSet.of(
            StructureKind.DIAPHRAGM,
            StructureKind.LUNG,
            StructureKind.PLEURA,
            StructureKind.LIVER,
            StructureKind.ORGAN,
            StructureKind.VESSEL,
            StructureKind.LESION,
            StructureKind.OTHER);

    /** A large body with a high diaphragm: 120 kg at a stature of 1.75 m. */
    public static final BodyVariation HEAVY = new BodyVariation(1.22, 1.25, 1, 10, 0.1, 28);

    /** A high liver in a body of usual size. */
    public static final BodyVariation HIGH_LIVER = new BodyVariation(1, 1, 1, 0, 0, HIGHEST_DOMES_MM);

    /** A barrel chest with a bent spine and low domes. */
    public static final BodyVariation BARREL =
            new BodyVariation(1.05, 1.05, 1, MOST_KYPHOSIS_DEG, MOST_BARREL, LOWEST_DOMES_MM);

    /**
     * A random variation.
     *
     * @param seed of the series
     * @param number of the body in the series, from 1
     */
    public static BodyVariation random(long seed, int number) {
        SplittableRandom random = new SplittableRandom(seed * 1_000_003L + number);
        return new BodyVariation(
                scale(random),
                scale(random),
                scale(random),
                MOST_KYPHOSIS_DEG * random.nextDouble(),
                MOST_BARREL * random.nextDouble(),
                LOWEST_DOMES_MM + (HIGHEST_DOMES_MM - LOWEST_DOMES_MM) * random.nextDouble());
    }

    /** Reciprocal factors are equally likely. */
    private static double scale(SplittableRandom random) {
        return LEAST_SCALE * StrictMath.pow(MOST_SCALE / LEAST_SCALE, random.nextDouble());
    }

    /** The variation in words: {@code 0.91 x 1.10 x 1.02, kyphosis 12 deg, barrel 0.20, domes +5 mm}. */
    public String description() {
        return Numbers.format(
                "%.2f x %.2f x %.2f, kyphosis %.0f deg, barrel %.2f, domes %+.0f mm",
                scaleX, scaleY, scaleZ, kyphosisDeg, barrel, domeLiftMm);
    }

    /**
     * The body of this size and shape, with its further organs.
     *
     * @param body with a diaphragm, ribs and vertebrae, LPS, mm
     */
    public Thorax of(Thorax body, String name) {
        Landmarks at = Landmarks.of(body);
        List<Structure> mapped = new ArrayList<>(mapped(body.structures(), at));
        Thorax thorax = new Thorax(name, mapped, body.notes());
        mapped.replaceAll(s -> s.kind() == StructureKind.DIAPHRAGM ? s.withMesh(withinCage(s.mesh(), thorax)) : s);
        return new Thorax(name, mapped, body.notes())
                .withOrgans(() -> mapped(body.organs().get(), at));
    }

    private List<Structure> mapped(List<Structure> structures, Landmarks at) {
        return structures.stream().map(s -> mapped(s, at)).toList();
    }

    private Structure mapped(Structure s, Landmarks at) {
        double[] p = s.mesh().positions().clone();
        boolean soft = SOFT.contains(s.kind());
        for (int k = 0; k < p.length; k += 3) {
            if (soft) {
                raise(p, k, at);
            }
            deepen(p, k, at);
            bend(p, k, at);
            p[k] *= scaleX;
            p[k + 1] *= scaleY;
            p[k + 2] *= scaleZ;
        }
        return s.withMesh(s.mesh().withPositions(p));
    }

    /**
     * The sheet moved inward where its thoracic face stands outside the inner envelope of the cage, which does not
     * scale with the bones exactly. Each abdominal vertex goes with the nearest thoracic one, so that the thickness
     * stays.
     */
    private static TriangleMesh withinCage(TriangleMesh sheet, Thorax body) {
        CageEnvelope cage = new CageEnvelope(body);
        Diaphragm faces = Diaphragm.withTrefoilTendon(sheet);
        double[] p = sheet.positions().clone();
        int[] thoracic = IntStream.range(0, sheet.vertexCount())
                .filter(faces::isThoracic)
                .toArray();
        for (int v = 0; v < sheet.vertexCount(); v++) {
            int outer = faces.isThoracic(v) ? v : nearest(sheet, v, thoracic);
            double inward = cage.at(sheet.x(outer), sheet.y(outer), sheet.z(outer)) - OUTSIDE_MM;
            if (inward > 0) {
                double azimuth = cage.azimuth(sheet.x(outer), sheet.y(outer));
                p[3 * v] -= inward * StrictMath.sin(azimuth);
                p[3 * v + 1] -= inward * StrictMath.cos(azimuth);
            }
        }
        return sheet.withPositions(p);
    }

    private static int nearest(TriangleMesh sheet, int vertex, int[] among) {
        int nearest = among[0];
        double leastMm = Double.POSITIVE_INFINITY;
        for (int other : among) {
            double mm = MeshMeasure.distance(sheet, vertex, other);
            if (mm < leastMm) {
                leastMm = mm;
                nearest = other;
            }
        }
        return nearest;
    }

    /** Raises a point below the apex by a share of the lift: all of it under the roof, nothing at the wall. */
    private void raise(double[] p, int k, Landmarks at) {
        double dx = at.outward(0, p[k]);
        double dy = at.outward(1, p[k + 1]);
        double bottom = at.sheet[2];
        double top = at.sheet[5];
        double out = 1 - SmoothBlends.smoothstep((Math.sqrt(dx * dx + dy * dy) - ROOF) / (WALL - ROOF));
        double foot = bottom + FOOT * (top - bottom);
        double z = p[k + 2];
        double height = z < top
                ? SmoothBlends.smoothstep((z - foot) / (top - foot))
                : 1 - SmoothBlends.smoothstep((z - top) / (at.apex - top));
        p[k + 2] = z + domeLiftMm * out * height;
    }

    /** Makes the chest deeper about the front of the spine, most at the middle height of the ribs. */
    private void deepen(double[] p, int k, Landmarks at) {
        double share = (p[k + 2] - at.ribs[2]) / (at.ribs[5] - at.ribs[2]);
        double bump = share <= 0 || share >= 1 ? 0 : StrictMath.sin(Math.PI * share);
        double forward = Math.max(0, at.spineFront - p[k + 1]);
        p[k + 1] -= barrel * bump * forward;
        p[k + 2] += RISE * barrel * SmoothBlends.smoothstep(share * 2) * forward;
    }

    /** Bends the body forward about the front of the spine, from the lowest rib up. */
    private void bend(double[] p, int k, Landmarks at) {
        double height = at.ribs[5] - at.ribs[2];
        double along = p[k + 2] - at.ribs[2];
        if (along <= 0 || kyphosisDeg == 0) {
            return;
        }
        double curvature = Math.toRadians(kyphosisDeg) / height;
        double angle = curvature * along;
        double behind = p[k + 1] - at.spineFront;
        p[k + 1] = at.spineFront - (1 - StrictMath.cos(angle)) / curvature + behind * StrictMath.cos(angle);
        p[k + 2] = at.ribs[2] + StrictMath.sin(angle) / curvature + behind * StrictMath.sin(angle);
    }

    /**
     * Where the maps act. Boxes are minimum x, y, z, then maximum x, y, z, mm.
     *
     * @param sheet box of the diaphragm
     * @param ribs box of the ribs
     * @param apex highest point of the lungs
     * @param spineFront mean y of the fronts of the vertebrae
     */
    private record Landmarks(double[] sheet, double[] ribs, double apex, double spineFront) {
        static Landmarks of(Thorax body) {
            double[] sheet = bounds(body, StructureKind.DIAPHRAGM);
            double[] ribs = bounds(body, StructureKind.RIB);
            double spine = body.structuresOf(StructureKind.VERTEBRA).stream()
                    .mapToDouble(s -> s.mesh().bounds()[1])
                    .average()
                    .orElse(ribs[4]);
            return new Landmarks(sheet, ribs, Math.max(bounds(body, StructureKind.LUNG)[5], sheet[5] + 1), spine);
        }

        /** Distance from the middle of the sheet along an axis, relative to half of the sheet's extent. */
        double outward(int axis, double at) {
            return (2 * at - sheet[axis] - sheet[axis + 3]) / (sheet[axis + 3] - sheet[axis]);
        }

        private static double[] bounds(Thorax body, StructureKind kind) {
            List<Structure> all = body.structuresOf(kind);
            if (all.isEmpty()) {
                throw new IllegalArgumentException(body.name() + ": found no " + kind + ", expected one");
            }
            return BoundingBoxes.of(all.stream().map(Structure::mesh));
        }
    }
}
