package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.EdgeTable;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.patient.OrganExtension;
import org.phrenic.patient.PatientBody;

/**
 * Brings the soft organs of a template whose bones are placed to what a scan has of organs. First all of them follow a
 * field so smooth that an organ of which the scan shows nothing moves with its neighbours and keeps its shape
 * ({@link SmoothField}); then those that the scan shows, and the sheets about them, follow finer displacements
 * ({@link DisplacementField}). Bones stay.
 */
final class OrganFit {
    private static final SmoothField.Scale[] SMOOTH = {new SmoothField.Scale(450, 20), new SmoothField.Scale(220, 12)};
    private static final int SMOOTH_ROUNDS = 4;
    private static final int SMOOTH_POINTS = 80;
    private static final double ORGAN_SIGMA_MM = 4;
    private static final double BONE_SIGMA_MM = 5;
    private static final int SMOOTH_BONE_POINTS = 250;
    /** Radii of the displacement fields, mm. */
    private static final double[] RADII_MM = {90, 60, 40, 30, 22};

    private static final int STEPS_PER_RADIUS = 5;
    /** Number of bone points that are kept fixed. */
    private static final int BONE_POINTS = 1200;
    /** Number of points of a base that are kept fixed, as many as of other surfaces count. */
    private static final int BASE_POINTS = 500;

    /** Height of a diaphragm with its serous membranes, mm. */
    private static final double SHEET_MM = 4;
    /** Start of the search for the base of a lung below a point, mm. */
    private static final double BELOW_MM = 250;
    /** Share of the points of a liver that the lungs may indent; the others decide how far it is lowered. */
    private static final double LOWEST_SHARE = 0.1;
    /** Greatest indentation by a lung, mm; a deeper one flattens the liver. */
    private static final double INDENTATION_MM = 12;

    private static final Set<StructureKind> EXTENSIBLE =
            EnumSet.of(StructureKind.LUNG, StructureKind.LIVER, StructureKind.ORGAN);

    static final Set<StructureKind> BONES = EnumSet.of(
            StructureKind.RIB,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.VERTEBRA,
            StructureKind.DISC);

    private final List<Structure> template;
    private final List<SharedStructure> shared;

    /**
     * @param template placed structures, replaced in the list
     * @param shared structures that scan and template have
     */
    OrganFit(List<Structure> template, List<SharedStructure> shared) {
        this.template = template;
        this.shared = shared.stream().filter(s -> !BONES.contains(s.kind())).toList();
    }

    /** Places the organs; returns the names of those that continue an organ which the scan truncates. */
    Set<String> fit() {
        Set<String> extended = new HashSet<>();
        if (!shared.isEmpty()) {
            followSmoothly();
            followClosely();
            extended.addAll(extend());
        }
        if (shared.stream().noneMatch(s -> s.kind() == StructureKind.LIVER)) {
            for (int i = 0; i < template.size(); i++) {
                if (template.get(i).kind() == StructureKind.LIVER) {
                    template.set(i, belowLungs(template.get(i)));
                }
            }
        }
        return extended;
    }

    /** Keeps what the scan shows of the closed organs that it truncates; returns their names. */
    private Set<String> extend() {
        return IntStream.range(0, template.size())
                .parallel()
                .filter(i -> EXTENSIBLE.contains(template.get(i).kind()))
                .mapToObj(i -> {
                    Structure s = template.get(i);
                    Optional<SharedStructure> cut = truncated(s);
                    cut.ifPresent(
                            organ -> template.set(i, s.withMesh(OrganExtension.extended(organ.organ(), s.mesh()))));
                    return cut.map(organ -> s.name());
                })
                .flatMap(Optional::stream)
                .collect(Collectors.toSet());
    }

    /** The structure of the scan that an organ of the template continues. */
    private Optional<SharedStructure> truncated(Structure s) {
        return shared.stream()
                .filter(other -> !other.isComplete()
                        && other.organ().structure().isSameAs(s)
                        && new EdgeTable(other.scan()).isClosed()
                        && new EdgeTable(s.mesh()).isClosed())
                .findFirst();
    }

    /** Lowers a liver that the scan does not show as a whole until it lies below the bases of the lungs. */
    private Structure belowLungs(Structure liver) {
        List<TriangleTree> bases = lungs().stream()
                .map(DiaphragmaticSurface::of)
                .filter(base -> base.triangleCount() > 0)
                .map(TriangleTree::new)
                .toList();
        double[] p = liver.mesh().positions().clone();
        double[] room = new double[p.length / 3];
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (int v = 0; v < room.length; v++) {
            room[v] = Double.POSITIVE_INFINITY;
            for (TriangleTree base : bases) {
                if (base.nearestAlongRay(p[3 * v], p[3 * v + 1], p[3 * v + 2] - BELOW_MM, 0, 0, 1, hit)) {
                    room[v] = Math.min(room[v], hit.rayParameter - BELOW_MM - SHEET_MM);
                }
            }
        }
        double[] sorted = room.clone();
        Arrays.sort(sorted);
        double shift = Math.min(0, sorted[(int) (LOWEST_SHARE * (sorted.length - 1))]);
        for (int v = 0; v < room.length; v++) {
            p[3 * v + 2] += Math.max(shift - INDENTATION_MM, Math.min(shift, room[v]));
        }
        return liver.withMesh(liver.mesh().withPositions(p));
    }

    /** Lungs of the scan where it has them whole, those of the template otherwise. */
    private List<TriangleMesh> lungs() {
        List<TriangleMesh> lungs = new ArrayList<>();
        for (Structure s : template) {
            if (s.kind() == StructureKind.LUNG) {
                lungs.add(shared.stream()
                        .filter(other ->
                                other.isComplete() && other.organ().structure().isSameAs(s))
                        .map(SharedStructure::scan)
                        .findFirst()
                        .orElse(s.mesh()));
            }
        }
        return lungs;
    }

    private void followSmoothly() {
        List<SurfacePair> pairs = pairs();
        PointPairs bones = new PointPairs();
        double[] fixed = bonePoints(SMOOTH_BONE_POINTS);
        bones.addAll(fixed, fixed, BONE_SIGMA_MM);
        SmoothField field = null;
        for (int round = 0; round < SMOOTH_ROUNDS; round++) {
            PointPairs all = new PointPairs();
            all.addAll(bones);
            for (SurfacePair pair : pairs) {
                if (field != null) {
                    pair.place(field);
                }
                all.addAll(pair.nearest(SMOOTH_POINTS, ORGAN_SIGMA_MM));
            }
            double[] displacements = all.to();
            double[] from = all.from();
            for (int i = 0; i < from.length; i++) {
                displacements[i] -= from[i];
            }
            field = new SmoothField(all, displacements, SMOOTH, 0, 0);
        }
        move(field, s -> true);
    }

    private void followClosely() {
        List<SurfacePair> pairs = pairs();
        PointPairs unseen = unseenBases();
        for (double radius : RADII_MM) {
            for (int step = 0; step < STEPS_PER_RADIUS; step++) {
                double[][] points = correspondences(pairs, unseen);
                double[] bounds = MeshMerge.merge(
                                template.stream().map(Structure::mesh).toList())
                        .bounds();
                DisplacementField field = new DisplacementField(points[0], points[1], radius, bounds);
                pairs.parallelStream().forEach(pair -> pair.transformTemplate(field));
                move(field, this::isSeenOrSheet);
            }
        }
    }

    private boolean isSeenOrSheet(Structure s) {
        return s.kind() == StructureKind.DIAPHRAGM
                || s.kind() == StructureKind.SKIN
                || shared.stream().anyMatch(other -> other.organ().structure().isSameAs(s));
    }

    private List<SurfacePair> pairs() {
        List<SurfacePair> pairs = new ArrayList<>();
        for (SharedStructure s : shared) {
            TriangleMesh placed =
                    PatientBody.merged(template, s.organ().structure()).orElseThrow();
            if (s.kind() != StructureKind.LUNG) {
                pairs.add(new SurfacePair(s.organ(), s.scan(), placed, false));
                continue;
            }
            TriangleMesh base = DiaphragmaticSurface.of(s.scan());
            TriangleMesh templateBase = DiaphragmaticSurface.of(placed);
            pairs.add(new SurfacePair(
                    s.organ(),
                    DiaphragmaticSurface.complement(s.scan()),
                    DiaphragmaticSurface.complement(placed),
                    true));
            if (base.triangleCount() > 0 && templateBase.triangleCount() > 0 && !endsAbove(s, templateBase)) {
                pairs.add(new SurfacePair(s.organ(), base, templateBase, false));
            }
        }
        return pairs;
    }

    private void move(PointTransform map, Predicate<Structure> which) {
        IntStream.range(0, template.size())
                .parallel()
                .filter(i -> !BONES.contains(template.get(i).kind()) && which.test(template.get(i)))
                .forEach(i -> template.set(i, map.apply(template.get(i))));
    }

    private double[] bonePoints(int count) {
        TriangleMesh bone = MeshMerge.merge(template.stream()
                .filter(s -> BONES.contains(s.kind()))
                .map(Structure::mesh)
                .toList());
        return sampled(bone, count);
    }

    /** About so many vertices of a surface. */
    private static double[] sampled(TriangleMesh mesh, int count) {
        int stride = Math.max(1, mesh.vertexCount() / count);
        double[] points = new double[3 * ((mesh.vertexCount() + stride - 1) / stride)];
        for (int i = 0; i < points.length / 3; i++) {
            System.arraycopy(mesh.positions(), 3 * i * stride, points, 3 * i, 3);
        }
        return points;
    }

    /**
     * Points, kept fixed, on bases of lungs of which the scan shows none. Finer displacements would draw them along
     * with the wall of the mediastinum at the end of the scan.
     */
    private PointPairs unseenBases() {
        PointPairs points = new PointPairs();
        for (SharedStructure s : shared) {
            if (s.kind() == StructureKind.LUNG && s.cutAt().contains("I")) {
                TriangleMesh base = DiaphragmaticSurface.of(
                        PatientBody.merged(template, s.organ().structure()).orElseThrow());
                double[] fixed = endsAbove(s, base) ? sampled(base, BASE_POINTS) : new double[0];
                points.addAll(fixed, fixed, 1);
            }
        }
        return points;
    }

    /**
     * Whether the scan ends above the base of a lung, where the template is placed, and most of what faces down of it
     * is the end of the scan.
     */
    private static boolean endsAbove(SharedStructure lung, TriangleMesh base) {
        if (!lung.cutAt().contains("I")
                || base.triangleCount() == 0
                || base.bounds()[5] >= lung.scan().bounds()[2]) {
            return false;
        }
        boolean[] down = DiaphragmaticSurface.vertexMask(lung.scan());
        boolean[] atCut = lung.organ().verticesAtCut(SurfacePair.CUT_MM);
        long all = IntStream.range(0, down.length).filter(v -> down[v]).count();
        long cut =
                IntStream.range(0, down.length).filter(v -> down[v] && atCut[v]).count();
        return 2 * cut > all;
    }

    private double[][] correspondences(List<SurfacePair> pairs, PointPairs unseen) {
        PointPairs all = new PointPairs();
        all.addAll(unseen);
        pairs.parallelStream().map(SurfacePair::correspondences).toList().forEach(points -> {
            for (int i = 0; i < points.from().size(); i++) {
                all.add(points.from().get(i), points.to().get(i), 1);
            }
        });
        double[] fixed = bonePoints(BONE_POINTS);
        all.addAll(fixed, fixed, 1);
        return new double[][] {all.from(), all.to()};
    }
}
