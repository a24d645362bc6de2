package org.phrenic.patient.diaphragm;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The base of one lung, of one or several lobes: faces whose normal points down, with no lung below them. A steep face
 * belongs to the base only if its normal points toward the base's centre, for the base is concave; the face above the
 * heart points away from it.
 */
final class LungBase {
    /** Level faces: within 26 degrees of the horizontal. */
    private static final double LEVEL = -0.9;
    /** Steepest faces: within 6 degrees of the vertical. */
    private static final double STEEP = -0.1;
    /** Share of the base's level area below its stated top. */
    private static final double TOP_SHARE = 0.9;
    /** Level faces higher than this above the middle one, mm, lie over the heart. */
    private static final double HEART_MM = 30;
    /**
     * Share of a lung's underside, in plan, below the middle of its base: the heart takes up to a third of it. At a
     * deep inspiration the base is steep, and most of its level faces are those of its lower border.
     */
    private static final double MIDDLE_SHARE = 0.4;
    /** Parts of the underside higher than this above that middle, mm, lie over the heart or at the end of a scan. */
    private static final double STEEP_BASE_MM = 50;
    /** Share of the base, in plan, below its dome: what is higher lies beside the heart. */
    private static final double DOME_SHARE = 0.8;
    /** Faces higher than this above the top, mm, lie over the heart or at the hilum. */
    private static final double ABOVE_TOP_MM = 6;
    /** Offset of a ray's origin below its face, mm. */
    private static final double CLEAR_MM = 0.5;
    /** Faces of a base above organs: within 41 degrees of the horizontal. */
    private static final double ABOVE_ORGANS = -0.75;
    /** Upward component of the normal of an organ's roof. */
    private static final double ROOF = 0.5;
    /** Least share of a base that lies above the roofs of organs, for a judgement of the distance between. */
    static final double LEAST_ABOVE = 0.4;
    /** Least share of a template's left base above an organ that tells where it lies, such as the spleen. */
    private static final double LEAST_AT = 0.05;
    /** A lung of whose base three quarters lie higher above organs, mm, does not lie on the diaphragm. */
    private static final double PARTED_MM = 35;
    /** Neither does one the top of whose base is higher above that of the organs, mm. */
    private static final double PARTED_TOP_MM = 50;

    /** A right base of which three quarters lie higher above organs, mm, is noted: a diaphragm is thinner. */
    private static final double NOTED_MM = 15;

    /**
     * The organs below a base.
     *
     * @param roof top of their upper surfaces, mm
     * @param gap height above them, mm, beyond which three quarters of the base lie
     * @param parted whether the base does not lie on the diaphragm
     */
    record Below(double roof, double gap, boolean parted) {}

    private final Side side;
    private final boolean inScan;
    final TriangleTree tree;
    private final double[] normals;
    private final double[] centre = new double[2];
    private double top = Double.NEGATIVE_INFINITY;
    private double dome;
    /** Height of the base above organs, mm, if it does not lie on the diaphragm; else 0. */
    private double partedMm;
    /** Height above organs, mm, beyond which 3/4 of a base lie that may have air or fluid below it; else 0. */
    private double gapMm;
    /** Whether that is known from the base of the other lung alone. */
    private boolean besideOther;
    /** Whether organs of the scan lie close below a template's left lung. */
    private boolean isAtOrgans;

    /**
     * @param organs the organs below, if there are any
     * @param all these with bowel and ascites, if there are any
     */
    private LungBase(
            Side side, TriangleMesh lung, boolean inScan, Optional<TriangleTree> organs, Optional<TriangleTree> all) {
        this.side = side;
        this.inScan = inScan;
        tree = new TriangleTree(lung);
        normals = MeshMeasure.triangleNormals(lung);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double[] area = new double[lung.triangleCount()];
        double[] plan = new double[area.length];
        double[] height = new double[area.length];
        double[] cross = new double[3];
        double total = 0;
        for (int t = 0; t < area.length; t++) {
            double[] m = MeshMeasure.centroid(lung, t);
            height[t] = m[2];
            double up = normals[3 * t + 2];
            if (up < 0 && tree.countAlongRay(m[0], m[1], m[2] - CLEAR_MM, 0, 0, -1, hit) == 0) {
                double whole = 0.5 * MeshMeasure.triangleCrossProduct(lung, t, cross);
                plan[t] = -up * whole;
                area[t] = up < LEVEL ? whole : 0;
            }
            total += area[t];
            centre[0] += area[t] * m[0];
            centre[1] += area[t] * m[1];
        }
        centre[0] /= Math.max(total, Double.MIN_NORMAL);
        centre[1] /= Math.max(total, Double.MIN_NORMAL);
        double[] box = lung.bounds();
        if (total == 0) {
            centre[0] = 0.5 * (box[0] + box[3]);
            centre[1] = 0.5 * (box[1] + box[4]);
            top = box[2];
        }
        int[] order = sorted(height);
        if (total > 0) {
            double middle = quantile(order, area, height, 0.5, Double.POSITIVE_INFINITY);
            top = quantile(order, area, height, TOP_SHARE, Double.POSITIVE_INFINITY);
            if (top > middle + HEART_MM) {
                top = quantile(order, area, height, TOP_SHARE, middle + HEART_MM);
            }
        }
        double middle = quantile(order, plan, height, MIDDLE_SHARE, Double.POSITIVE_INFINITY);
        dome = quantile(order, plan, height, DOME_SHARE, middle + STEEP_BASE_MM);
        if (top < middle) {
            top = dome;
        } else if (total > 0 && top > middle + STEEP_BASE_MM) {
            top = Math.max(dome, quantile(order, area, height, TOP_SHARE, middle + STEEP_BASE_MM));
        }
        judge(organs, all);
    }

    private void judge(Optional<TriangleTree> organs, Optional<TriangleTree> all) {
        double least = inScan || side == Side.RIGHT ? LEAST_ABOVE : LEAST_AT;
        Optional<Below> near = organs.flatMap(with -> below(with, least));
        if (near.isEmpty() || (!near.get().parted() && side != Side.RIGHT && inScan)) {
            return;
        }
        Optional<Below> any = all.isPresent() ? all.flatMap(with -> below(with, least)) : near;
        boolean parted = near.get().parted() && any.isPresent() && any.get().parted();
        if (!inScan && side != Side.RIGHT) {
            // Fat and bowel lie between stomach and dome: organs of the scan do not tell a template's left dome.
            isAtOrgans = !parted;
        } else if (parted) {
            partedMm = top - near.get().roof();
            top = near.get().roof();
            dome = top;
        } else if (side == Side.RIGHT && any.isPresent()) {
            double gap = Math.min(near.get().gap(), any.get().gap());
            gapMm = gap > NOTED_MM ? gap : 0;
        }
    }

    /** Compares the base with the upper surfaces of the organs below; empty if too little of it lies above them. */
    Optional<Below> below(TriangleTree below, double least) {
        TriangleMesh lung = tree.mesh();
        double[] roofs = MeshMeasure.triangleNormals(below.mesh());
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double[] area = new double[lung.triangleCount()];
        double[] gap = new double[area.length];
        double[] level = new double[area.length];
        double[] roof = new double[area.length];
        double[] cross = new double[3];
        double base = 0;
        for (int t = 0; t < area.length; t++) {
            double[] m = MeshMeasure.centroid(lung, t);
            if (normals[3 * t + 2] > ABOVE_ORGANS
                    || tree.countAlongRay(m[0], m[1], m[2] - CLEAR_MM, 0, 0, -1, hit) > 0) {
                continue;
            }
            double here = 0.5 * MeshMeasure.triangleCrossProduct(lung, t, cross);
            base += here;
            if (below.nearestAlongRay(m[0], m[1], m[2] + PARTED_MM, 0, 0, -1, hit)
                    && roofs[3 * hit.triangle + 2] > ROOF) {
                area[t] = here;
                gap[t] = m[2] - hit.z;
                roof[t] = hit.z;
                level[t] = roofs[3 * hit.triangle + 2] > -LEVEL ? here : 0;
            }
        }
        if (Arrays.stream(level).sum() > 0 && Arrays.stream(area).sum() > least * base) {
            double roofTop = quantile(sorted(roof), level, roof, TOP_SHARE, Double.POSITIVE_INFINITY);
            double quarter = quantile(sorted(gap), area, gap, 0.25, Double.POSITIVE_INFINITY);
            return Optional.of(new Below(roofTop, quarter, quarter > PARTED_MM || top > roofTop + PARTED_TOP_MM));
        }
        return Optional.empty();
    }

    private static int[] sorted(double[] keys) {
        return IntStream.range(0, keys.length)
                .boxed()
                .sorted(Comparator.comparingDouble(t -> keys[t]))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    /** Height below which a share of the area lies, of the faces up to a ceiling. */
    private static double quantile(int[] order, double[] area, double[] height, double share, double ceiling) {
        double total = 0;
        for (int t : order) {
            total += height[t] <= ceiling ? area[t] : 0;
        }
        double sum = 0;
        double found = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < order.length && sum < share * total; i++) {
            sum += area[order[i]];
            found = area[order[i]] > 0 ? height[order[i]] : found;
        }
        return found;
    }

    /** The bases of the right and the left lung, as far as the body has them. */
    static List<LungBase> of(Thorax body) {
        List<Structure> organs = ContactingOrgans.abdominal(body);
        List<Structure> between = ContactingOrgans.between(body);
        Optional<TriangleTree> below = inScan(body, organs);
        Optional<TriangleTree> all = between.isEmpty()
                ? Optional.empty()
                : inScan(body, Stream.concat(organs.stream(), between.stream()).toList());
        return Arrays.stream(new Side[] {Side.RIGHT, Side.LEFT})
                .flatMap(side -> of(body, side, below, all).stream())
                .toList();
    }

    /** Those of some organs that the scan shows, as one surface. */
    static Optional<TriangleTree> inScan(Thorax body, List<Structure> organs) {
        List<TriangleMesh> shown =
                organs.stream().filter(body::isInScan).map(Structure::mesh).toList();
        return shown.isEmpty() ? Optional.empty() : Optional.of(new TriangleTree(MeshMerge.merge(shown)));
    }

    private static Optional<LungBase> of(
            Thorax body, Side side, Optional<TriangleTree> below, Optional<TriangleTree> all) {
        List<Structure> lobes = body.structuresOf(StructureKind.LUNG).stream()
                .filter(s -> s.side() == side && s.mesh().triangleCount() > 0)
                .toList();
        if (lobes.isEmpty()) {
            return Optional.empty();
        }
        TriangleMesh lung = MeshMerge.merge(lobes.stream().map(Structure::mesh).toList());
        boolean inScan = lobes.stream().anyMatch(body::isInScan);
        // A template's right dome is told by the liver, which fills it, alone.
        Optional<TriangleTree> under =
                inScan || side == Side.LEFT ? below : inScan(body, body.structuresOf(StructureKind.LIVER));
        return Optional.of(new LungBase(side, lung, inScan, under, all));
    }

    /** Whether the scan shows the lung. */
    boolean isInScan() {
        return inScan;
    }

    /** Whether the base lies on the diaphragm. */
    boolean liesOnDiaphragm() {
        return partedMm == 0;
    }

    Side side() {
        return side;
    }

    /** Highest point of the lung, mm. */
    double apex() {
        return tree.mesh().bounds()[5];
    }

    /** A template's left lung, lowered as far as a right one laid on the liver, unless it lies on scanned organs. */
    LungBase beside(LungBase right) {
        if (inScan || right.inScan || isAtOrgans || right.partedMm == 0) {
            return this;
        }
        double[] p = tree.mesh().positions().clone();
        for (int z = 2; z < p.length; z += 3) {
            p[z] -= right.partedMm;
        }
        return new LungBase(side, tree.mesh().withPositions(p), false, Optional.empty(), Optional.empty());
    }

    /** Lowers the dome by so much, since it is known from the base of the other lung alone. */
    void lower(double mm) {
        besideOther = true;
        partedMm = mm;
        dome -= mm;
        top = dome;
    }

    /** A note on a lung that does not lie on the diaphragm, or perhaps not. */
    Optional<String> note() {
        if (liesOnDiaphragm()) {
            String gap =
                    "three quarters of the base of the right lung lie more than %.0f mm above the organs below: with"
                            + " air or fluid in the chest without a label between, the diaphragm lies lower than it"
                            + " is laid";
            return inScan && gapMm > 0 ? Optional.of(Numbers.format(gap, gapMm)) : Optional.empty();
        }
        String text = "the base of the %s lung reaches %.0f mm above the organs below the diaphragm: the diaphragm is"
                + " laid on these, as with fluid in the chest or lung without a label between; with"
                + " ascites without a label, or after resection of the liver, it lies higher";
        if (besideOther) {
            text = "the base of the %s lung stands %.0f mm higher than beside the other one in people, and the scan"
                    + " labels no organ below it: the diaphragm is laid at the level of the other side, as with"
                    + " fluid in the chest or lung without a label between; with a paresis of that half, or after"
                    + " resection of a lobe, it lies higher";
        } else if (!inScan) {
            text = "the %s lung, which the scan does not show, is placed with its base %.0f mm above the liver: the"
                    + " diaphragm is laid on the liver, and the left dome, where the scan shows no lung or organ at"
                    + " it, as much lower; with a liver that is small or was resected it lies higher";
        }
        return Optional.of(Numbers.format(text, side == Side.RIGHT ? "right" : "left", partedMm));
    }

    /** Height of the top of the base, or of the organs below if it does not lie on the diaphragm, mm. */
    double top() {
        return top;
    }

    /**
     * Height of the dome, mm: of the base without its highest part, which at inspiration is the one beside the heart,
     * for the pericardium holds the tendon; of the organs below if the base does not lie on the diaphragm.
     */
    double dome() {
        return dome;
    }

    /** Cosine between a direction from below and the inward normal of the face that a ray has met. */
    double facing(TriangleTree.Hit hit, double[] d) {
        int t = 3 * hit.triangle;
        return -(normals[t] * d[0] + normals[t + 1] * d[1] + normals[t + 2] * d[2]);
    }

    /** Whether the face that a ray from below has met first belongs to the base. */
    boolean isBase(TriangleTree.Hit hit) {
        int t = 3 * hit.triangle;
        if (hit.z > top + ABOVE_TOP_MM) {
            return false;
        }
        double inward = normals[t] * (centre[0] - hit.x) + normals[t + 1] * (centre[1] - hit.y);
        return normals[t + 2] < LEVEL || (normals[t + 2] < STEEP && inward > 0);
    }
}
