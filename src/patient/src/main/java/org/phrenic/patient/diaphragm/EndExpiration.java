package org.phrenic.patient.diaphragm;

import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.anatomy.LesionPlace;
import org.phrenic.anatomy.OrganNames;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/**
 * Brings a scan at inspiration to end-expiration. Ribs turn back on their helical axes by the share s of a full
 * inspiration that {@link BreathLevel} states; the sternum follows, cartilages bend between both. Domes, with the
 * organs above and below them and what lies in the liver, rise by the descent d of that level:
 *
 * <pre>
 * z' = z + d p(u, v) g(z),   x' = x + g(z) (X'(u, z') - X(u, z)),   y' = y + g(z) (Y'(v, z') - Y(v, z))
 * </pre>
 *
 * Above the domes the share 1 - g goes with the bones nearby ({@link BoneCarriage}). u and v are the place of a point
 * in the breadth and depth of the cage ({@link CageEnvelope}) at its height, -1 to 1; X and Y state that place, X' and
 * Y' the same place in the cage whose ribs have turned, at the height to which the point rises. p is the share of the
 * domes' descent over the plan of the cage, 1 at the domes, less in front and in the middle (physiology C3); what stays
 * behind the domes does so by {@code t tanh(d (1 - p) / t)}, at most the height t of a vertebra with its disc, for at
 * end-expiration the tendon stands no more than that below the domes. g is 1 about the domes and falls to 0 at the apex
 * of the lungs and in the pelvis. As d is at most {@value #GREATEST_SHARE} of the lungs' height, z' increases with z.
 */
public final class EndExpiration {
    /** Share of the descent in the midline, where the pericardium holds the tendon (2 of 5 to 10 cm). */
    private static final double MIDDLE_SHARE = 0.3;
    /** Distance from the midline at which the descent is whole, in half-breadths of the cage. */
    private static final double WHOLE_BREADTH = 0.5;
    /** Share of the descent at the front: posterior to middle to anterior is 1 : 0.8 : 0.5. */
    private static final double FRONT_SHARE = 0.5;
    /**
     * Places behind and before the middle, in half-depths of the cage, between which the descent falls to that share.
     */
    private static final double BACK = 0.35;

    private static final double FRONT = -0.55;
    /** Depth below the domes to which everything rises with them, and over which that fades, mm. */
    private static final double WITH_DOMES_MM = 100;

    private static final double FADE_MM = 200;
    /** Greatest descent of a dome in a deep breath, mm: 5 to 10 cm. */
    private static final double GREATEST_MM = 100;
    /** Greatest descent as a share of the height of the lungs above their bases. */
    private static final double GREATEST_SHARE = 0.6;

    private static final int SECTOR_STEP = 4;
    /** Least downward component of the normals of a lung's base. */
    private static final double LEAST_NORMAL = 0.5;
    /** Height above the domes up to which surfaces belong to the base, mm: half the difference of both domes. */
    private static final double ABOVE_DOMES_MM = 15;
    /** Share of the base below its stated top. */
    private static final double TOP_SHARE = 0.95;

    private static final int RISE_ROUNDS = 4;
    /** Greatest change of the rise in a round. */
    private static final double FASTEST = 1.5;
    /**
     * Soft structures within the cage. The skin, muscles and other bones keep their places, and so do vessels and
     * unknown structures outside liver and chest.
     */
    private static final Set<StructureKind> SOFT =
            EnumSet.of(StructureKind.LUNG, StructureKind.LIVER, StructureKind.ORGAN, StructureKind.LESION);

    private static final Set<String> STILL = Set.of("spinal_cord", "thyroid_gland", "oesophagus", "esophagus", "brain");

    /** Organs that keep their volume, besides liver and kidneys. */
    private static final Set<String> SOLID = Set.of("heart", "spleen");

    private final BoneCarriage bones;
    private final LesionBones lesionBones;
    private final LiverContents inLiver;
    private final ChestContents inChest;
    /** How the liver of the scan keeps its volume; empty without a liver. */
    private final Optional<Stretch> ofLiver;

    private final CageEnvelope before;
    private final CageEnvelope after;
    private final double share;
    /** Rise d of the highest part of the domes, mm. */
    private double rise;

    /** Rise of the top of the domes, mm. */
    private final double domesMm;

    private final double domes;
    private final double apex;
    /** Height of a vertebra with its disc, mm. */
    private final double vertebra;

    private EndExpiration(List<Structure> scanned, Thorax completed, BreathLevel level) {
        share = Math.min(1, level.share());
        vertebra = level.descentMm() / level.descent();
        bones = new BoneCarriage(completed, share);
        List<Structure> skeleton = completed.structures().stream()
                .filter(s -> isCage(s.kind()) || s.kind() == StructureKind.VERTEBRA || s.kind() == StructureKind.DISC)
                .toList();
        before = new CageEnvelope(new Thorax(completed.name(), skeleton, List.of()));
        after = before.about(new Thorax(
                completed.name(), skeleton.stream().map(s -> turned(s, s)).toList(), List.of()));
        List<Structure> lungs = completed.structuresOf(StructureKind.LUNG);
        domes = UnequalBases.of(completed, level.parted()).stream()
                .mapToDouble(LungBase::dome)
                .average()
                .orElseThrow();
        apex = lungs.stream().mapToDouble(s -> s.mesh().bounds()[5]).max().orElseThrow();
        List<double[]> base = roofs(completed);
        // The domes of an inspired lung stand in front, where less than the whole descent is taken back.
        double greatest = Math.min(GREATEST_MM, GREATEST_SHARE * (apex - domes));
        rise = Math.min(level.descentMm(), greatest);
        double top = top(base);
        for (int i = 0; i < RISE_ROUNDS; i++) {
            double risen = top(base.stream().map(this::raised).toList()) - top;
            rise = Math.min(greatest, rise * Math.min(FASTEST, level.descentMm() / Math.max(risen, 1)));
        }
        domesMm = rise < greatest
                ? level.descentMm()
                : Math.min(
                        level.descentMm(), top(base.stream().map(this::raised).toList()) - top);
        lesionBones = new LesionBones(completed);
        Optional<Structure> liver =
                scanned.stream().filter(s -> s.kind() == StructureKind.LIVER).findFirst();
        inLiver = new LiverContents(scanned, liver);
        inChest = new ChestContents(scanned);
        ofLiver = liver.map(s -> stretch(s.mesh(), risen(s.mesh())));
    }

    /** Vertices of the lungs' bases at the domes or, where no lung lies on the diaphragm, of the roofs below them. */
    private List<double[]> roofs(Thorax body) {
        List<double[]> bases = body.structuresOf(StructureKind.LUNG).stream()
                .flatMap(s -> facing(s.mesh(), -1))
                .toList();
        return !bases.isEmpty()
                ? bases
                : ContactingOrgans.abdominal(body).stream()
                        .flatMap(s -> facing(s.mesh(), 1))
                        .toList();
    }

    /** Vertices of a surface up to the domes that face up (1) or down (-1). */
    private Stream<double[]> facing(TriangleMesh mesh, int side) {
        double[] normals = MeshMeasure.vertexNormals(mesh);
        return IntStream.range(0, mesh.vertexCount())
                .filter(v -> side * normals[3 * v + 2] > LEAST_NORMAL && mesh.z(v) < domes + ABOVE_DOMES_MM)
                .mapToObj(v -> new double[] {mesh.x(v), mesh.y(v), mesh.z(v)});
    }

    private static double top(List<double[]> base) {
        double[] z = base.stream().mapToDouble(p -> p[2]).sorted().toArray();
        return z[(int) (TOP_SHARE * (z.length - 1))];
    }

    /**
     * Returns the structures of a scan at end-expiration, with a note that states the amounts. A diaphragm of the scan
     * is left out, since it is built anew.
     *
     * @param scanned body as scanned
     * @param completed the same body with ribs, vertebrae and lungs completed
     * @param level breath level of the scan
     * @throws IllegalArgumentException if the completed body has no cage
     */
    public static RaisedBody of(PatientBody scanned, PatientBody completed, BreathLevel level) {
        List<Structure> structures =
                scanned.structures().stream().map(PatientStructure::structure).toList();
        EndExpiration expiration = new EndExpiration(structures, completed.thorax(), level);
        List<PatientStructure> moved = scanned.structures().parallelStream()
                .filter(s -> s.structure().kind() != StructureKind.DIAPHRAGM)
                .map(s -> s.withStructure(expiration.moved(s.structure())))
                .toList();
        PatientBody body = new PatientBody(scanned.name(), moved, scanned.missing(), scanned.notes());
        return new RaisedBody(body, expiration.domesMm).withNote(scanned, level, expiration.rise, expiration.share);
    }

    private static boolean isCage(StructureKind kind) {
        return kind == StructureKind.RIB || kind == StructureKind.STERNUM || kind == StructureKind.COSTAL_CARTILAGE;
    }

    private Structure moved(Structure s) {
        if (isCage(s.kind())) {
            return turned(s, s);
        }
        if (inLiver.has(s)) {
            double[] risen = risen(s.mesh());
            return ofLiver.map(stretch -> stretch.of(s, risen))
                    .orElseGet(() -> s.withMesh(s.mesh().withPositions(risen)));
        }
        if (LesionBones.isOfBone(s)) {
            return lesionBones.of(s).map(bone -> turned(s, bone)).orElse(s);
        }
        boolean still =
                STILL.contains(s.name()) || LesionPlace.standsStill(s.name().toLowerCase(Locale.ROOT));
        return inChest.has(s) || (SOFT.contains(s.kind()) && !still) ? raised(s) : s;
    }

    /** A structure that goes with a bone, or is one. */
    private Structure turned(Structure s, Structure bone) {
        if (bone.kind() == StructureKind.COSTAL_CARTILAGE) {
            return s.withMesh(s.mesh().withPositions(bones.carried(s.mesh().positions())));
        }
        int body = bone.kind() == StructureKind.RIB
                ? bones.cage().rib(bone.level(), bone.side())
                : bones.cage().sternum();
        return !isCage(bone.kind()) || body < 0 ? s : withPoints(s, p -> bones.carried(body, p));
    }

    private static Structure withPoints(Structure s, UnaryOperator<double[]> map) {
        TriangleMesh mesh = s.mesh();
        double[] out = new double[mesh.positions().length];
        IntStream.range(0, mesh.vertexCount())
                .forEach(v ->
                        System.arraycopy(map.apply(new double[] {mesh.x(v), mesh.y(v), mesh.z(v)}), 0, out, 3 * v, 3));
        return s.withMesh(mesh.withPositions(out));
    }

    /** A soft organ at end-expiration. */
    private Structure raised(Structure s) {
        double[] risen = risen(s.mesh());
        boolean solid = s.kind() == StructureKind.LIVER
                || SOLID.contains(OrganNames.words(s.name()))
                || OrganNames.isKidney(s.name().toLowerCase(Locale.ROOT));
        return solid
                ? stretch(s.mesh(), risen).of(s, risen)
                : s.withMesh(s.mesh().withPositions(risen));
    }

    /** The vertices of a surface that rises with the domes. */
    private double[] risen(TriangleMesh mesh) {
        double[] p = mesh.positions();
        double[] displacement = bones.displacement(mesh);
        double[] out = new double[p.length];
        for (int i = 0; i < p.length; i += 3) {
            double above = p[i + 2] > domes ? 1 - heightShare(p[i + 2]) : 0;
            double[] q = raised(new double[] {p[i], p[i + 1], p[i + 2]});
            for (int axis = 0; axis < 3; axis++) {
                out[i + axis] = q[axis] + above * displacement[i + axis];
            }
        }
        return out;
    }

    /**
     * The stretch along z by which a solid organ keeps its volume.
     *
     * @param heldMm height at which it touches the diaphragm, mm
     */
    private record Stretch(double heldMm, double factor) {
        Structure of(Structure s, double[] risen) {
            double[] p = risen.clone();
            for (int i = 2; i < p.length; i += 3) {
                p[i] = heldMm + factor * (p[i] - heldMm);
            }
            return s.withMesh(s.mesh().withPositions(p));
        }
    }

    private Stretch stretch(TriangleMesh scanned, double[] moved) {
        TriangleMesh mesh = scanned.withPositions(moved);
        double factor = MeshMeasure.hasInside(scanned) && MeshMeasure.hasInside(mesh)
                ? MeshMeasure.signedVolume(scanned) / MeshMeasure.signedVolume(mesh)
                : 1;
        return new Stretch(scanned.centre()[2] > domes ? mesh.bounds()[2] : mesh.bounds()[5], factor);
    }

    /** A point that rises with the domes. */
    private double[] raised(double[] p) {
        double[] from = extent(before, p[2]);
        double u = 2 * share(p[0], from[0], from[1]) - 1;
        double v = 2 * share(p[1], from[2], from[3]) - 1;
        double fade = heightShare(p[2]);
        double z = p[2] + rise * planShare(u, v) * fade;
        double[] to = extent(after, z);
        return new double[] {
            p[0] + 0.5 * fade * ((1 - u) * (to[0] - from[0]) + (1 + u) * (to[1] - from[1])),
            p[1] + 0.5 * fade * ((1 - v) * (to[2] - from[2]) + (1 + v) * (to[3] - from[3])),
            z
        };
    }

    private static double share(double x, double low, double high) {
        return Math.max(0, Math.min(1, (x - low) / (high - low)));
    }

    /** Least and greatest x, least and greatest y of the cage at a height, mm. */
    private double[] extent(CageEnvelope cage, double height) {
        // Higher up, where ribs 1 to 3 close the cage, the breadth at the domes counts.
        double z = Math.min(height, domes + rise);
        double[] box = {cage.x(z), cage.x(z), cage.y(z), cage.y(z)};
        for (int i = 0; i < CageEnvelope.SECTORS; i += SECTOR_STEP) {
            double azimuth = CageEnvelope.azimuth(i);
            double[] q = cage.point(azimuth, cage.radius(azimuth, z), z);
            box[0] = Math.min(box[0], q[0]);
            box[1] = Math.max(box[1], q[0]);
            box[2] = Math.min(box[2], q[1]);
            box[3] = Math.max(box[3], q[1]);
        }
        return box;
    }

    /** Share p of the descent in the plan of the cage: u to the left, v to the back, -1 to 1. */
    private double planShare(double u, double v) {
        double beside = MIDDLE_SHARE + (1 - MIDDLE_SHARE) * SmoothBlends.smoothstep(Math.abs(u) / WHOLE_BREADTH);
        double behind = FRONT_SHARE + (1 - FRONT_SHARE) * SmoothBlends.smoothstep((v - FRONT) / (BACK - FRONT));
        double behindDomes = (1 - beside * behind) * Math.max(rise, Double.MIN_NORMAL) / vertebra;
        return 1 - (1 - beside * behind) * saturated(behindDomes);
    }

    /** tanh(x) / x. */
    private static double saturated(double x) {
        return x < 1e-6 ? 1 : StrictMath.tanh(x) / x;
    }

    /** Share g of the descent over the height. */
    private double heightShare(double z) {
        if (z > domes) {
            return 1 - SmoothBlends.smoothstep((z - domes) / (apex - domes));
        }
        return FallOff.at(Math.max(0, domes - WITH_DOMES_MM - z), FADE_MM);
    }
}
