package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.patient.ExpectedStructures;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/**
 * Completes a body with the structures that are missing from its scan or truncated. A template thorax is registered to
 * the structures that both have. The registration has three stages: bounding boxes, scaling in the transverse plane,
 * and displacement fields of decreasing radius ({@link DisplacementField}). The last two use nearest points of both
 * surfaces.
 */
public final class BodyCompletion {
    private static final int SCALING_STEPS = 20;
    /** Radii of the displacement fields, mm: first for all structures, then for soft organs only. */
    private static final double[] BONE_RADII_MM = {160, 120, 90};

    private static final double[] SOFT_RADII_MM = {120, 90, 60, 40, 30, 22};
    private static final int STEPS_PER_RADIUS = 5;
    /** Number of bone points that are kept fixed while soft organs are displaced. */
    private static final int FIXED_POINTS = 1200;

    private static final Set<StructureKind> BONES = EnumSet.of(
            StructureKind.RIB,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.VERTEBRA,
            StructureKind.DISC);

    /** Structures transformed by a similarity. Cartilages connect them and may deform. */
    private static final Set<StructureKind> KEEPING_SHAPE =
            EnumSet.of(StructureKind.RIB, StructureKind.STERNUM, StructureKind.VERTEBRA, StructureKind.DISC);

    private final PatientBody body;
    private final List<Structure> template;
    private final List<SurfacePair> pairs = new ArrayList<>();
    private int shared;

    private BodyCompletion(PatientBody body, Thorax template) {
        this.body = body;
        this.template = new ArrayList<>(template.structures());
        for (PatientStructure s : body.structures()) {
            templateOf(s).ifPresent(mesh -> addPairs(s, mesh));
        }
    }

    private void addPairs(PatientStructure s, TriangleMesh mesh) {
        shared++;
        TriangleMesh scan = s.structure().mesh();
        if (s.structure().kind() != StructureKind.LUNG) {
            pairs.add(
                    new SurfacePair(s, scan, mesh, BONES.contains(s.structure().kind())));
            return;
        }
        TriangleMesh base = DiaphragmaticSurface.of(scan);
        TriangleMesh templateBase = DiaphragmaticSurface.of(mesh);
        pairs.add(
                new SurfacePair(s, DiaphragmaticSurface.complement(scan), DiaphragmaticSurface.complement(mesh), true));
        if (base.triangleCount() > 0 && templateBase.triangleCount() > 0) {
            pairs.add(new SurfacePair(s, base, templateBase, false));
        }
    }

    /** The structure of the template that corresponds to a structure of the body, in its current position. */
    private Optional<TriangleMesh> templateOf(PatientStructure s) {
        return PatientBody.merged(template.stream().filter(t -> isSame(t, s.structure())));
    }

    private static boolean isSame(Structure a, Structure b) {
        return a.kind() == b.kind()
                && a.level() == b.level()
                && a.side() == b.side()
                && (!a.kind().isNamed() || a.name().equals(b.name()));
    }

    /**
     * Returns the completed body. If the scan has no complete lung, the body is returned with a note and is not
     * completed.
     *
     * @param template template thorax, LPS, mm, at end-expiration
     */
    public static PatientBody complete(PatientBody body, Thorax template) {
        boolean lung = body.structures().stream()
                .anyMatch(s ->
                        s.structure().kind() == StructureKind.LUNG && s.scan().isPresent() && s.isComplete());
        if (!lung) {
            return body.withNotes(List.of("not completed from " + template.name()
                    + ": the scan has no whole lung, and without one a virtual thorax cannot be brought to it"));
        }
        BodyCompletion completion = new BodyCompletion(body, template);
        completion.register();
        return completion.completed(template.name());
    }

    private void register() {
        List<SurfacePair> complete =
                pairs.stream().filter(SurfacePair::isComplete).toList();
        transform(
                AffineTransform3D.betweenBoxes(
                        box(complete.stream().map(SurfacePair::template).toList()),
                        box(complete.stream().map(SurfacePair::scan).toList())),
                true);
        for (int step = 0; step < SCALING_STEPS; step++) {
            double[][] points = correspondences(true);
            transform(AffineTransform3D.horizontalScaling(points[0], points[1]), true);
        }
        List<Structure> undeformed = List.copyOf(template);
        displace(BONE_RADII_MM, true);
        for (int i = 0; i < undeformed.size(); i++) {
            Structure s = undeformed.get(i);
            if (KEEPING_SHAPE.contains(s.kind())) {
                double[] from = s.mesh().positions();
                double[] to = template.get(i).mesh().positions();
                template.set(i, AffineTransform3D.similarity(from, to).apply(s));
            }
        }
        displace(SOFT_RADII_MM, false);
    }

    private void displace(double[] radiiMm, boolean bones) {
        for (double radius : radiiMm) {
            for (int step = 0; step < STEPS_PER_RADIUS; step++) {
                double[][] points = correspondences(bones);
                double[] bounds = box(template.stream().map(Structure::mesh).toList());
                transform(new DisplacementField(points[0], points[1], radius, bounds), bones);
            }
        }
    }

    /**
     * Corresponding points of template and scan. For bones, only pairs that guide bones; otherwise all pairs plus fixed
     * bone points.
     */
    private double[][] correspondences(boolean bones) {
        List<double[]> from = new ArrayList<>();
        List<double[]> to = new ArrayList<>();
        pairs.parallelStream()
                .filter(pair -> !bones || pair.guidesBones())
                .map(SurfacePair::correspondences)
                .toList()
                .forEach(points -> {
                    from.addAll(points.from());
                    to.addAll(points.to());
                });
        if (!bones) {
            TriangleMesh bone = MeshMerge.merge(template.stream()
                    .filter(s -> BONES.contains(s.kind()))
                    .map(Structure::mesh)
                    .toList());
            int stride = Math.max(1, bone.vertexCount() / FIXED_POINTS);
            for (int v = 0; v < bone.vertexCount(); v += stride) {
                double[] p = {bone.x(v), bone.y(v), bone.z(v)};
                from.add(p);
                to.add(p);
            }
        }
        return new double[][] {flat(from), flat(to)};
    }

    private static double[] flat(List<double[]> points) {
        double[] all = new double[3 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            System.arraycopy(points.get(i), 0, all, 3 * i, 3);
        }
        return all;
    }

    /** Transforms the whole template, or only its soft structures. */
    private void transform(PointTransform map, boolean bones) {
        pairs.parallelStream()
                .filter(pair -> bones || !BONES.contains(pair.kind()))
                .forEach(pair -> pair.transformTemplate(map));
        List<Structure> moved = template.parallelStream()
                .map(s -> bones || !BONES.contains(s.kind()) ? map.apply(s) : s)
                .toList();
        template.clear();
        template.addAll(moved);
    }

    private PatientBody completed(String templateName) {
        List<PatientStructure> all = new ArrayList<>();
        for (PatientStructure s : body.structures()) {
            Optional<DistanceSummary> off = templateOf(s).map(mesh -> SurfacePair.distanceToScan(s, mesh));
            if (off.isEmpty() || s.isComplete()) {
                all.add(off.map(s::withDistanceToScan).orElse(s));
            }
        }
        int added = 0;
        for (Structure structure : template) {
            if (all.stream()
                    .noneMatch(s -> isSame(s.structure(), structure) && s.source() == PatientStructure.Source.SCAN)) {
                Optional<PatientStructure> cut = body.structures().stream()
                        .filter(s -> isSame(s.structure(), structure))
                        .findFirst();
                all.add(new PatientStructure(
                        structure,
                        PatientStructure.Source.VIRTUAL,
                        cut.flatMap(PatientStructure::scan),
                        cut.map(s -> SurfacePair.distanceToScan(s, templateOf(s).orElseThrow()))));
                added++;
            }
        }
        all.sort(Comparator.comparing(s -> s.structure().name()));
        return new PatientBody(body.name(), all, ExpectedStructures.missing(all), body.notes())
                .withNotes(List.of(String.format(
                        Locale.ROOT,
                        "%d structures come from %s, brought to the %d that it shares with the scan",
                        added,
                        templateName,
                        shared)));
    }

    private static double[] box(List<TriangleMesh> meshes) {
        return MeshMerge.merge(meshes).bounds();
    }
}
