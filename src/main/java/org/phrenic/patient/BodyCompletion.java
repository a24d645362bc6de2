package org.phrenic.patient;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.Meshes;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.geometry.DistanceSummary;
import org.phrenic.geometry.TriangleMesh;

/**
 * Gives a body what its scan lacks: a template thorax is brought to the structures that both have, by the box about them (which gives the height), then stretches across and from front to back, then ever finer smooth warps ({@link WarpField}), each found from the points
 * of the two surfaces that lie nearest to each other; and lends its other structures. A structure that the scan cuts off is lent too, brought to the part that can be seen.
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
    private final List<SharedSurface> shared = new ArrayList<>();
    private int sharedOrgans;

    private BodyCompletion(FittedBody body, Thorax template) {
        this.template = new ArrayList<>(template.structures());
        for (Organ organ : body.organs()) {
            templateOf(organ).ifPresent(mesh -> {
                sharedOrgans++;
                share(organ, mesh);
            });
        }
    }

    private void share(Organ organ, TriangleMesh mesh) {
        TriangleMesh scan = organ.structure().mesh();
        if (organ.structure().kind() != StructureKind.LUNG) {
            shared.add(new SharedSurface(
                    organ, scan, mesh, BONES.contains(organ.structure().kind())));
            return;
        }
        TriangleMesh base = LungBaseFacet.of(scan);
        TriangleMesh templateBase = LungBaseFacet.of(mesh);
        shared.add(new SharedSurface(organ, LungBaseFacet.rest(scan), LungBaseFacet.rest(mesh), true));
        if (base.triangleCount() > 0 && templateBase.triangleCount() > 0) {
            shared.add(new SharedSurface(organ, base, templateBase, false));
        }
    }

    /** The template's structure of the same name as an organ, as it lies now. */
    private Optional<TriangleMesh> templateOf(Organ organ) {
        List<TriangleMesh> parts = template.stream()
                .filter(s -> isSame(s, organ.structure()))
                .map(Structure::mesh)
                .toList();
        return parts.isEmpty() ? Optional.empty() : Optional.of(Meshes.merge(parts));
    }

    private static boolean isSame(Structure a, Structure b) {
        return a.kind() == b.kind() && a.level() == b.level() && a.side() == b.side();
    }

    /**
     * The body with the structures of a template that it lacks, or as it is, with a note, if the scan has no whole lung to bring a template to.
     *
     * @param template LPS, mm, at end-expiration
     */
    public static FittedBody complete(FittedBody body, Thorax template) {
        boolean lung = body.organs().stream()
                .anyMatch(o -> o.structure().kind() == StructureKind.LUNG
                        && o.scan().map(Organ.Scan::isWhole).orElse(false));
        if (!lung) {
            return noted(
                    body,
                    "not completed from " + template.name()
                            + ": the scan has no whole lung, and without one a virtual thorax cannot be brought to it");
        }
        BodyCompletion completion = new BodyCompletion(body, template);
        completion.fit();
        return completion.completed(body, template.name());
    }

    private static FittedBody noted(FittedBody body, String note) {
        List<String> notes = new ArrayList<>(body.notes());
        notes.add(note);
        return new FittedBody(body.name(), body.organs(), body.missing(), notes);
    }

    private void fit() {
        List<SharedSurface> whole =
                shared.stream().filter(SharedSurface::isWhole).toList();
        move(
                AffineMap.ofBoxes(
                        box(whole.stream().map(SharedSurface::template).toList()),
                        box(whole.stream().map(SharedSurface::scan).toList())),
                true);
        for (int step = 0; step < STEPS; step++) {
            double[][] pairs = pairs(true);
            move(AffineMap.stretch(pairs[0], pairs[1]), true);
        }
        List<Structure> straight = List.copyOf(template);
        warp(BONE_RADII_MM, true);
        for (int i = 0; i < straight.size(); i++) {
            if (KEEPING_SHAPE.contains(straight.get(i).kind())) {
                double[] p = straight.get(i).mesh().positions().clone();
                AffineMap.similarity(p, template.get(i).mesh().positions()).apply(p);
                template.set(i, straight.get(i).withMesh(straight.get(i).mesh().withPositions(p)));
            }
        }
        warp(SOFT_RADII_MM, false);
    }

    private void warp(double[] radiiMm, boolean bones) {
        for (double radius : radiiMm) {
            for (int step = 0; step < WARPS_A_RADIUS; step++) {
                double[][] pairs = pairs(bones);
                double[] bounds = box(template.stream().map(Structure::mesh).toList());
                move(new WarpField(pairs[0], pairs[1], radius, bounds), bones);
            }
        }
    }

    /** @param bones only of what guides bones; otherwise of all, and of points of bone, which stay */
    private double[][] pairs(boolean bones) {
        List<double[]> from = new ArrayList<>();
        List<double[]> to = new ArrayList<>();
        shared.parallelStream()
                .filter(s -> !bones || s.guidesBones())
                .map(SharedSurface::pairs)
                .toList()
                .forEach(pairs -> {
                    from.addAll(pairs.from());
                    to.addAll(pairs.to());
                });
        if (!bones) {
            TriangleMesh bone = Meshes.merge(template.stream()
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

    private void move(PointMap map, boolean bones) {
        shared.parallelStream().filter(s -> bones || !BONES.contains(s.kind())).forEach(s -> s.move(map));
        List<Structure> moved = template.parallelStream()
                .map(s -> bones || !BONES.contains(s.kind()) ? moved(s, map) : s)
                .toList();
        template.clear();
        template.addAll(moved);
    }

    private static Structure moved(Structure structure, PointMap map) {
        double[] p = structure.mesh().positions().clone();
        map.apply(p);
        return structure.withMesh(structure.mesh().withPositions(p));
    }

    private FittedBody completed(FittedBody body, String from) {
        List<Organ> organs = new ArrayList<>();
        List<String> lent = new ArrayList<>();
        for (Organ organ : body.organs()) {
            Optional<DistanceSummary> off = templateOf(organ).map(mesh -> SharedSurface.off(organ, mesh));
            if (off.isEmpty() || organ.scan().map(Organ.Scan::isWhole).orElse(true)) {
                organs.add(off.map(organ::withOffScan).orElse(organ));
            }
        }
        for (Structure structure : template) {
            if (organs.stream().noneMatch(o -> isSame(o.structure(), structure) && o.source() == Organ.Source.SCAN)) {
                Optional<Organ> seen = body.organs().stream()
                        .filter(o -> isSame(o.structure(), structure))
                        .findFirst();
                organs.add(new Organ(
                        structure,
                        Organ.Source.VIRTUAL,
                        seen.flatMap(Organ::scan),
                        seen.map(o -> SharedSurface.off(o, templateOf(o).orElseThrow()))));
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
        return new FittedBody(body.name(), organs, ThoraxList.missing(organs), notes);
    }

    private static double[] box(List<TriangleMesh> meshes) {
        return Meshes.merge(meshes).bounds();
    }
}
