package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.cage.RibCourse;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;

/**
 * First alignment of a template to a scan: pose, size and proportions from landmarks of the structures that both have,
 * refined by nearest points of lungs and liver, unless bones tell more, and of what the scan cuts off. Rotation and
 * proportions that the structures leave open stay those of an upright body in LPS.
 */
final class RoughAlignment {
    /** Fractions of a rib's course from the back that serve as landmarks; the posterior end may be missing. */
    private static final double[] RIB_FRACTIONS = {0.4, 0.6, 0.8, 1};

    private static final double VERTEBRA_SIGMA_MM = 4;
    private static final double BONE_SIGMA_MM = 8;
    private static final double LUNG_SIGMA_MM = 10;
    private static final double ORGAN_SIGMA_MM = 25;
    private static final double CUT_SIGMA_MM = 60;
    /** Weight of no rotation and of an unchanged size, relative to the landmarks. */
    private static final double POSE_HOLD = 0.01;

    private static final double ARM_MM = 150;
    private static final int REFINEMENTS = 12;
    /** Nearest points of one organ in a refinement. */
    private static final int POINTS = 120;
    /** The same of one structure that the scan cuts off. */
    private static final int CUT_POINTS = 12;
    /**
     * Landmarks of whole structures from which on truncated ones count by nearest points, as organs do and where there
     * are any, not by their centroids. Truncated vertebrae count so in any case.
     */
    private static final int ENOUGH_LANDMARKS = 8;

    private final double plane;
    private final PointPairs landmarks = new PointPairs();
    /** Vertebrae and ribs, whole or in part. */
    private final List<SharedStructure> bones = new ArrayList<>();
    /**
     * Structures that the scan cuts off. The centroid of the part lies farther within the scan than that of the whole
     * structure in the template, as if the body were smaller.
     */
    private final List<SharedStructure> cut = new ArrayList<>();
    /** Vertebrae that tell the lengths along the body; none where others do. */
    private PointPairs spine = new PointPairs();

    RoughAlignment(double plane) {
        this.plane = plane;
    }

    /** Adds the landmarks of a structure and its counterpart. */
    void add(SharedStructure shared) {
        StructureKind kind = shared.kind();
        if (kind == StructureKind.RIB || kind == StructureKind.VERTEBRA) {
            bones.add(shared);
        }
        if (!shared.isComplete()) {
            cut.add(shared);
        } else if (kind == StructureKind.RIB) {
            RibCourse from = RibCourse.of(shared.template(), shared.side());
            RibCourse to = RibCourse.of(shared.scan(), shared.side());
            for (double f : RIB_FRACTIONS) {
                landmarks.add(from.at(f * from.lengthMm()), to.at(f * to.lengthMm()), BONE_SIGMA_MM);
            }
        } else if (kind == StructureKind.LUNG) {
            List<double[]> from = lungPoints(shared.template());
            List<double[]> to = lungPoints(shared.scan());
            for (int i = 0; i < from.size(); i++) {
                landmarks.add(from.get(i), to.get(i), LUNG_SIGMA_MM);
            }
        } else {
            double sigma =
                    switch (kind) {
                        case VERTEBRA -> VERTEBRA_SIGMA_MM;
                        case STERNUM, COSTAL_CARTILAGE -> BONE_SIGMA_MM;
                        case LIVER, ORGAN -> ORGAN_SIGMA_MM;
                        default -> CUT_SIGMA_MM;
                    };
            landmarks.add(centroid(shared.template()), centroid(shared.scan()), sigma);
        }
    }

    /**
     * Adds the centroid of a part. It lies within the scan, off the centroid of the whole structure by up to half of
     * the length that is missing, which is its standard deviation. That of a vertebra is little off.
     */
    private static void addCentroid(PointPairs pairs, SharedStructure part) {
        double[] whole = part.template().bounds();
        double[] shown = part.scan().bounds();
        double sigma = part.kind() == StructureKind.VERTEBRA ? BONE_SIGMA_MM : CUT_SIGMA_MM;
        for (int k = 0; k < 3; k++) {
            sigma = Math.max(sigma, 0.5 * (whole[k + 3] - whole[k] - (shown[k + 3] - shown[k])));
        }
        pairs.add(centroid(part.template()), centroid(part.scan()), sigma);
    }

    /** Centre of the area of a surface, mm. */
    static double[] centroid(TriangleMesh mesh) {
        double[] areas = MeshMeasure.vertexAreas(mesh);
        double[] c = new double[3];
        double total = 0;
        for (int v = 0; v < areas.length; v++) {
            total += areas[v];
            for (int k = 0; k < 3; k++) {
                c[k] += areas[v] * mesh.positions()[3 * v + k];
            }
        }
        return new double[] {c[0] / total, c[1] / total, c[2] / total};
    }

    /** Middles of the six faces of the bounding box. */
    private static List<double[]> lungPoints(TriangleMesh lung) {
        double[] box = lung.bounds();
        double[] centre = lung.centre();
        List<double[]> points = new ArrayList<>();
        for (int side = 0; side < 6; side++) {
            double[] p = centre.clone();
            p[side % 3] = box[side];
            points.add(p);
        }
        return points;
    }

    /** Pose, size and proportions of the template. */
    TemplateMap align(List<SurfacePair> organs) {
        boolean enough = landmarks.count() >= ENOUGH_LANDMARKS;
        PointPairs first = new PointPairs();
        first.addAll(landmarks);
        cut.stream().filter(s -> !enough).forEach(s -> addCentroid(first, s));
        spine = new PointPairs();
        TemplateMap map = fit(first);
        spine = spine(map, organs);
        boolean bonesTell = BoneFit.bonesTell(bones, map, organs);
        PointPairs known = new PointPairs();
        known.addAll(landmarks);
        List<SurfacePair> cutPairs = new ArrayList<>();
        for (SharedStructure s : cut) {
            if (bonesTell && (s.kind() == StructureKind.LIVER || s.kind() == StructureKind.LUNG)) {
                continue;
            }
            if (enough || s.kind() == StructureKind.VERTEBRA) {
                cutPairs.add(s.pair(true));
            } else {
                addCentroid(known, s);
            }
        }
        List<SurfacePair> guides = organs.stream()
                .filter(organ -> !bonesTell || BoneFit.tellsBesideBones(organ))
                .toList();
        for (int i = 0; i < REFINEMENTS && !organs.isEmpty(); i++) {
            PointPairs pairs = new PointPairs();
            pairs.addAll(known);
            for (SurfacePair pair : cutPairs) {
                pair.place(map);
                pairs.addAll(pair.nearest(CUT_POINTS, BONE_SIGMA_MM));
            }
            for (SurfacePair pair : guides) {
                pair.place(map);
                pairs.addAll(
                        pair.nearest(POINTS, pair.kind() == StructureKind.LUNG ? 2 * LUNG_SIGMA_MM : CUT_SIGMA_MM));
            }
            map = fit(pairs);
        }
        return map;
    }

    /**
     * Vertebrae that the scan shows whole or but for a small part, if it shows enough of them and ends below within the
     * lungs. Below such a scan a body goes on as its spine does: upper ribs, the other marks of its length, slope more
     * or less steeply in other people.
     */
    private PointPairs spine(TemplateMap map, List<SurfacePair> organs) {
        PointPairs pairs = new PointPairs();
        boolean endsInLungs = organs.stream().noneMatch(o -> o.kind() == StructureKind.LUNG && o.isComplete())
                && cut.stream()
                        .anyMatch(
                                s -> s.kind() == StructureKind.LUNG && s.cutAt().contains("I"));
        List<SharedStructure> shown = bones.stream()
                .filter(s -> endsInLungs && BoneFit.isShown(s, map))
                .toList();
        for (SharedStructure s : shown.size() < BoneFit.LEAST_VERTEBRAE ? List.<SharedStructure>of() : shown) {
            TriangleMesh placed = map.apply(s.template());
            TriangleMesh fitted = placed.withPositions(VertebraFit.fit(placed, s.scan()));
            pairs.add(centroid(s.template()), centroid(fitted), VERTEBRA_SIGMA_MM);
        }
        return pairs;
    }

    private Optional<SymmetricAffine.Spine> upright(RigidMotion pose, double scale) {
        if (spine.count() == 0) {
            return Optional.empty();
        }
        double[] to = spine.to();
        pose.inverse().apply(to);
        PointPairs upright = new PointPairs();
        upright.addAll(spine.from(), to, VERTEBRA_SIGMA_MM);
        return Optional.of(SymmetricAffine.Spine.of(upright, scale));
    }

    private TemplateMap fit(PointPairs pairs) {
        double[] weights = pairs.weights();
        double[] from = pairs.from();
        double[] to = pairs.to();
        double[] p = PointPairs.centroid(from, weights);
        double[] q = PointPairs.centroid(to, weights);
        double[][] centred = {weighted(from, p, weights), weighted(to, q, weights)};
        RigidMotion turn = RigidMotion.fit(centred[0], centred[1]);
        double scale = scale(turn, centred[0], centred[1]);
        // The point (plane, y, z) of the template at the height of the centroid goes to (0, y, z) upright.
        double[] middle = turn.apply(scale * (plane - p[0]), 0, 0);
        double[] turned = turn.apply(0, p[1], p[2]);
        RigidMotion pose = RigidMotion.translation(
                        q[0] + middle[0] - turned[0], q[1] + middle[1] - turned[1], q[2] + middle[2] - turned[2])
                .after(turn);
        double[] upright = to.clone();
        pose.inverse().apply(upright);
        return TemplateMap.of(pose, SymmetricAffine.fit(from, upright, weights, plane, scale, upright(pose, scale)));
    }

    /**
     * Points relative to their centroid, scaled by the roots of their weights, and their opposites, so that the mean is
     * 0; with points on the axes that hold the rotation.
     */
    private static double[] weighted(double[] points, double[] centroid, double[] weights) {
        int n = points.length;
        double[] out = new double[2 * n + 18];
        for (int i = 0; i < n; i++) {
            out[i] = Math.sqrt(weights[i / 3]) * (points[i] - centroid[i % 3]);
            out[n + i] = -out[i];
        }
        double hold = Math.sqrt(POSE_HOLD * Arrays.stream(weights).sum()) * ARM_MM;
        for (int k = 0; k < 3; k++) {
            out[2 * n + 4 * k] = hold;
            out[2 * n + 9 + 4 * k] = -hold;
        }
        return out;
    }

    private static double scale(RigidMotion turn, double[] from, double[] to) {
        double[] turned = from.clone();
        turn.apply(turned);
        double along = 0;
        double square = 0;
        for (int i = 0; i < from.length; i++) {
            along += turned[i] * to[i];
            square += turned[i] * turned[i];
        }
        return along / square;
    }

    /** Mean x of the spine and the sternum of a template, mm. */
    static double planeOfSymmetry(Thorax whole) {
        return whole.structures().stream()
                .filter(s -> s.kind() == StructureKind.VERTEBRA || s.kind() == StructureKind.STERNUM)
                .mapToDouble(s -> s.mesh().centre()[0])
                .average()
                .orElse(0);
    }
}
