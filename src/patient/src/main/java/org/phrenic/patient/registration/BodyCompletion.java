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
 * Gives a body what its scan lacks: a template thorax is brought to the structures that both have, by the box about
 * them (which gives the height), then stretches across and from front to back, then ever finer smooth warps
 * ({@link DisplacementField}), each found from the points of the two surfaces that lie nearest to each other; and lends
 * its other structures. A structure that the scan cuts off is lent too, brought to the part that can be seen.
 */
public final class BodyCompletion {
    private static final int STEPS = 20;
    /** Radii of the warps that bones follow, and of those of soft organs between them. */
    private static final double[] BONE_RADII_MM = {160, 120, 90};

    private static final double[] SOFT_RADII_MM = {120, 90, 60, 40, 30, 22};
    private static final int WARPS_A_RADIUS = 5;
    /** Points that hold the soft warps where bone is. */
    private static final int HELD = 1200;

    private static final Set<StructureKind> BONES = EnumSet.of(
            StructureKind.RIB,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.VERTEBRA,
            StructureKind.DISC);

    /** Bones that are turned, shifted and scaled but not bent; cartilages are, as they join them. */
    private static final Set<StructureKind> KEEPING_SHAPE =
            EnumSet.of(StructureKind.RIB, StructureKind.STERNUM, StructureKind.VERTEBRA, StructureKind.DISC);

    private final List<Structure> template;
    private final List<SurfacePair> shared = new ArrayList<>();
    private int sharedOrgans;

    private BodyCompletion(PatientBody body, Thorax template) {
        this.template = new ArrayList<>(template.structures());
        for (PatientStructure organ : body.structures()) {
            templateOf(organ).ifPresent(mesh -> {
                sharedOrgans++;
                share(organ, mesh);
            });
        }
    }

    private void share(PatientStructure organ, TriangleMesh mesh) {
        TriangleMesh scan = organ.structure().mesh();
        if (organ.structure().kind() != StructureKind.LUNG) {
            shared.add(new SurfacePair(
                    organ, scan, mesh, BONES.contains(organ.structure().kind())));
            return;
        }
        TriangleMesh base = DiaphragmaticSurface.of(scan);
        TriangleMesh templateBase = DiaphragmaticSurface.of(mesh);
        shared.add(new SurfacePair(
                organ, DiaphragmaticSurface.complement(scan), DiaphragmaticSurface.complement(mesh), true));
        if (base.triangleCount() > 0 && templateBase.triangleCount() > 0) {
            shared.add(new SurfacePair(organ, base, templateBase, false));
        }
    }

    /** The template's structure of the same name as an organ, as it lies now. */
    private Optional<TriangleMesh> templateOf(PatientStructure organ) {
        List<TriangleMesh> parts = template.stream()
                .filter(s -> isSame(s, organ.structure()))
                .map(Structure::mesh)
                .toList();
        return parts.isEmpty() ? Optional.empty() : Optional.of(MeshMerge.merge(parts));
    }

    private static boolean isSame(Structure a, Structure b) {
        return a.kind() == b.kind() && a.level() == b.level() && a.side() == b.side();
    }

    /**
     * The body with the structures of a template that it lacks, or as it is, with a note, if the scan has no whole lung
     * to bring a template to.
     *
     * @param template LPS, mm, at end-expiration
     */
    public static PatientBody complete(PatientBody body, Thorax template) {
        boolean lung = body.structures().stream()
                .anyMatch(o -> o.structure().kind() == StructureKind.LUNG
                        && o.scan().map(PatientStructure.Scan::isComplete).orElse(false));
        if (!lung) {
            return withNote(
                    body,
                    "not completed from " + template.name()
                            + ": the scan has no whole lung, and without one a virtual thorax cannot be brought to it");
        }
        BodyCompletion completion = new BodyCompletion(body, template);
        completion.fit();
        return completion.completed(body, template.name());
    }

    private static PatientBody withNote(PatientBody body, String note) {
        List<String> notes = new ArrayList<>(body.notes());
        notes.add(note);
        return new PatientBody(body.name(), body.structures(), body.missing(), notes);
    }

    private void fit() {
        List<SurfacePair> whole =
                shared.stream().filter(SurfacePair::isComplete).toList();
        transform(
                AffineTransform3D.betweenBoxes(
                        box(whole.stream().map(SurfacePair::template).toList()),
                        box(whole.stream().map(SurfacePair::scan).toList())),
                true);
        for (int step = 0; step < STEPS; step++) {
            double[][] pairs = correspondences(true);
            transform(AffineTransform3D.horizontalScaling(pairs[0], pairs[1]), true);
        }
        List<Structure> straight = List.copyOf(template);
        warp(BONE_RADII_MM, true);
        for (int i = 0; i < straight.size(); i++) {
            if (KEEPING_SHAPE.contains(straight.get(i).kind())) {
                double[] p = straight.get(i).mesh().positions().clone();
                AffineTransform3D.similarity(p, template.get(i).mesh().positions())
                        .apply(p);
                template.set(i, straight.get(i).withMesh(straight.get(i).mesh().withPositions(p)));
            }
        }
        warp(SOFT_RADII_MM, false);
    }

    private void warp(double[] radiiMm, boolean bones) {
        for (double radius : radiiMm) {
            for (int step = 0; step < WARPS_A_RADIUS; step++) {
                double[][] pairs = correspondences(bones);
                double[] bounds = box(template.stream().map(Structure::mesh).toList());
                transform(new DisplacementField(pairs[0], pairs[1], radius, bounds), bones);
            }
        }
    }

    /** @param bones only of what guides bones; otherwise of all, and of points of bone, which stay */
    private double[][] correspondences(boolean bones) {
        List<double[]> from = new ArrayList<>();
        List<double[]> to = new ArrayList<>();
        shared.parallelStream()
                .filter(s -> !bones || s.guidesBones())
                .map(SurfacePair::correspondences)
                .toList()
                .forEach(pairs -> {
                    from.addAll(pairs.from());
                    to.addAll(pairs.to());
                });
        if (!bones) {
            TriangleMesh bone = MeshMerge.merge(template.stream()
                    .filter(s -> BONES.contains(s.kind()))
                    .map(Structure::mesh)
                    .toList());
            int step = Math.max(1, bone.vertexCount() / HELD);
            for (int v = 0; v < bone.vertexCount(); v += step) {
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

    private void transform(PointTransform map, boolean bones) {
        shared.parallelStream().filter(s -> bones || !BONES.contains(s.kind())).forEach(s -> s.transformTemplate(map));
        List<Structure> moved = template.parallelStream()
                .map(s -> bones || !BONES.contains(s.kind()) ? moved(s, map) : s)
                .toList();
        template.clear();
        template.addAll(moved);
    }

    private static Structure moved(Structure structure, PointTransform map) {
        double[] p = structure.mesh().positions().clone();
        map.apply(p);
        return structure.withMesh(structure.mesh().withPositions(p));
    }

    private PatientBody completed(PatientBody body, String from) {
        List<PatientStructure> organs = new ArrayList<>();
        List<String> lent = new ArrayList<>();
        for (PatientStructure organ : body.structures()) {
            Optional<DistanceSummary> off = templateOf(organ).map(mesh -> SurfacePair.distanceToScan(organ, mesh));
            if (off.isEmpty()
                    || organ.scan().map(PatientStructure.Scan::isComplete).orElse(true)) {
                organs.add(off.map(organ::withDistanceToScan).orElse(organ));
            }
        }
        for (Structure structure : template) {
            if (organs.stream()
                    .noneMatch(o -> isSame(o.structure(), structure) && o.source() == PatientStructure.Source.SCAN)) {
                Optional<PatientStructure> seen = body.structures().stream()
                        .filter(o -> isSame(o.structure(), structure))
                        .findFirst();
                organs.add(new PatientStructure(
                        structure,
                        PatientStructure.Source.VIRTUAL,
                        seen.flatMap(PatientStructure::scan),
                        seen.map(
                                o -> SurfacePair.distanceToScan(o, templateOf(o).orElseThrow()))));
                lent.add(structure.name());
            }
        }
        organs.sort(Comparator.comparing(o -> o.structure().name()));
        List<String> notes = new ArrayList<>(body.notes());
        notes.add(String.format(
                Locale.ROOT,
                "%d structures come from %s, brought to the %d that it shares with the scan",
                lent.size(),
                from,
                sharedOrgans));
        return new PatientBody(body.name(), organs, ExpectedStructures.missing(organs), notes);
    }

    private static double[] box(List<TriangleMesh> meshes) {
        return MeshMerge.merge(meshes).bounds();
    }
}
