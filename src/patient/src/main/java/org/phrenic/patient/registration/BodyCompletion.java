package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.voxel.CutPlane;
import org.phrenic.patient.BodyPlausibility;
import org.phrenic.patient.ExpectedStructures;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.ScanFragments;
import org.phrenic.patient.ShownPlaces;
import org.phrenic.patient.TemplateParts;
import org.phrenic.patient.label.LabelTable;

/**
 * Completes a body from any field of view with the structures that are missing from its scan or truncated. A template
 * thorax is aligned by landmarks ({@link RoughAlignment}), its bones are fitted to those of the scan ({@link BoneFit}),
 * ribs that end short of the spine are extended ({@link RibExtension}), and soft organs follow the bones and what the
 * scan has of organs ({@link OrganFit}).
 */
public final class BodyCompletion {
    /** Structures transformed by a similarity. Ribs bend with the cage; cartilages connect bones and may deform. */
    private static final Set<StructureKind> KEEPING_SHAPE =
            EnumSet.of(StructureKind.STERNUM, StructureKind.VERTEBRA, StructureKind.DISC);
    /** Kinds that determine where a template lies. */
    private static final Set<StructureKind> GUIDES = EnumSet.of(
            StructureKind.RIB,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.VERTEBRA,
            StructureKind.LUNG,
            StructureKind.LIVER);

    /** Organs and vessels that lie against the spine or the wall and differ less than others. */
    private static final Set<String> AT_WALL = Set.of("kidney_L", "kidney_R", "spleen", "aorta", "inferior_vena_cava");

    private static final String KIDNEY = "kidney_";

    /**
     * Least volume of what the scan shows of a lung or liver that it cuts off, over the template's in a body of the
     * scan's size: a smaller piece says nothing of where the rest lies.
     */
    private static final double LEAST_SHARE = 0.03;

    /** The same where a side of the scan cuts it: a slab beside the midline does not show how low the lung reaches. */
    private static final double LEAST_SHARE_AT_SIDE = 0.15;

    /** The same of a vertebra: of the one above its end a scan shows the tip of the spinous process alone. */
    private static final double LEAST_SHARE_OF_VERTEBRA = 0.4;

    private final PatientBody body;
    private final List<Structure> rest;
    private final List<Structure> template = new ArrayList<>();
    private final List<SharedStructure> shared = new ArrayList<>();
    /** A spine under one label. */
    private final Optional<SurfacePair> spine;
    /** Organs beside the liver by which the template is placed where the scan shows neither bones nor lungs. */
    private final List<SharedStructure> organs;

    private final List<RibFit> ribs = new ArrayList<>();
    private Optional<String> sizeNote = Optional.empty();

    private BodyCompletion(PatientBody body, Thorax template) {
        this.body = body;
        rest = TemplateParts.of(template.structures(), body);
        double size = ScanFragments.size(body, template);
        List<PatientStructure> seen = new ArrayList<>();
        for (PatientStructure s : body.structures()) {
            if (seen.stream().noneMatch(other -> other.structure().isSameAs(s.structure()))) {
                seen.add(s);
                PatientBody.merged(rest, s.structure())
                        .map(mesh -> shared(s, mesh))
                        .filter(pair -> tells(pair, size))
                        .ifPresent(shared::add);
            }
        }
        boolean surer = shared.stream().anyMatch(s -> GUIDES.contains(s.kind()) && s.kind() != StructureKind.LIVER);
        spine = wholeSpine();
        organs = surer || spine.isPresent() ? List.of() : atWall(template);
    }

    /**
     * Organs at the wall that the scan shows, with those of the template, among its structures or its further organs.
     */
    private List<SharedStructure> atWall(Thorax whole) {
        List<Structure> ofTemplate = whole.structuresAndOrgans();
        return body.structures().stream()
                .filter(s -> AT_WALL.contains(s.structure().name()))
                .filter(s -> s.isComplete() || !s.structure().name().startsWith(KIDNEY))
                .flatMap(s -> ofTemplate.stream()
                        .filter(t -> t.name().equals(s.structure().name()))
                        .limit(1)
                        .map(t -> new SharedStructure(s, t.mesh())))
                .toList();
    }

    /**
     * Whether what the scan shows of a structure is enough to fit the template to it.
     *
     * @param size volume of the body over that of the template
     */
    private static boolean tells(SharedStructure s, double size) {
        boolean organ = s.kind() == StructureKind.LUNG || s.kind() == StructureKind.LIVER;
        boolean atSide = s.cutAt().contains("L") || s.cutAt().contains("R");
        boolean vertebra = s.kind() == StructureKind.VERTEBRA;
        double least = vertebra ? LEAST_SHARE_OF_VERTEBRA : atSide ? LEAST_SHARE_AT_SIDE : LEAST_SHARE;
        return !(organ || vertebra) || s.shownShare(s.template()) >= size * least;
    }

    /** The structure of the scan, with all its parts as one surface, and its counterpart. */
    private SharedStructure shared(PatientStructure s, TriangleMesh mesh) {
        List<PatientStructure> parts = body.structures().stream()
                .filter(other -> other.structure().isSameAs(s.structure()))
                .toList();
        if (parts.size() == 1) {
            return new SharedStructure(s, mesh);
        }
        Structure whole = s.structure()
                .withMesh(PatientBody.merged(
                                parts.stream().map(PatientStructure::structure).toList(), s.structure())
                        .orElseThrow());
        List<CutPlane> cuts =
                parts.stream().flatMap(part -> part.cuts().stream()).distinct().toList();
        return new SharedStructure(
                new PatientStructure(
                        whole,
                        s.source(),
                        s.scan()
                                .map(scan -> cuts.isEmpty()
                                        ? scan
                                        : scan.withCuts(cuts).withShown(shown(whole.mesh(), parts))),
                        s.distanceToScan()),
                mesh);
    }

    /** The outline of parts where the scan shows it: each vertex goes back with the nearest point of the parts. */
    private static TriangleMesh shown(TriangleMesh outline, List<PatientStructure> parts) {
        TriangleMesh now = MeshMerge.merge(
                parts.stream().map(part -> part.structure().mesh()).toList());
        double[] before = MeshMerge.merge(
                        parts.stream().map(PatientStructure::shown).toList())
                .positions();
        ShownPlaces places = new ShownPlaces(now, before);
        double[] p = outline.positions().clone();
        for (int i = 0; i < p.length; i += 3) {
            places.apply(p, i);
        }
        return outline.withPositions(p);
    }

    /**
     * Returns the completed body. A body without bones, lungs and liver is returned with a note and is not completed.
     *
     * @param template template thorax, LPS, mm, at end-expiration
     * @throws org.phrenic.file.BadInputException without the file's name, if people are not of the body's size
     */
    public static PatientBody complete(PatientBody body, Thorax template) {
        BodyCompletion completion = new BodyCompletion(body, template);
        if (completion.shared.stream().noneMatch(s -> GUIDES.contains(s.kind()))) {
            return body.withNotes(List.of("not completed from " + template.name()
                    + ": the scan has no bone, lung or liver by which a virtual thorax can be placed"));
        }
        completion.fitBones(template);
        Set<String> continued = new OrganFit(completion.template, completion.shared).fit();
        return completion.completed(template.name(), continued);
    }

    private void fitBones(Thorax whole) {
        double plane = RoughAlignment.planeOfSymmetry(whole);
        RoughAlignment rough = new RoughAlignment(plane);
        List<SurfacePair> pairs = new ArrayList<>();
        for (SharedStructure s : shared) {
            if (GUIDES.contains(s.kind())) {
                rough.add(s);
            }
            if (s.kind() == StructureKind.LUNG) {
                pairs.add(new SurfacePair(
                        s.organ(),
                        DiaphragmaticSurface.complement(s.scan()),
                        DiaphragmaticSurface.complement(s.template()),
                        true));
            } else if (s.kind() == StructureKind.LIVER) {
                pairs.add(s.pair(false));
            }
        }
        TemplateMap start = placedBy(rough, pairs);
        boolean ofVoxels = body.structures().stream().anyMatch(s -> s.scan().isPresent());
        BodyPlausibility size = new BodyPlausibility(start.affine().factors(), whole.name(), ofVoxels);
        size.require();
        sizeNote = size.note();
        spine.ifPresent(pairs::add);
        BoneFit bones = new BoneFit(start, plane, rest, shared, pairs);
        TemplateMap map = bones.fit();
        ribs.addAll(bones.ribs());
        Optional<AffineTransform3D> sternum = unseenSternum(map);
        template.addAll(rest.parallelStream()
                .map(s -> s.kind() == StructureKind.STERNUM && sternum.isPresent()
                        ? sternum.get().apply(s)
                        : placed(s, map))
                .toList());
    }

    /** Places the template by landmarks and surfaces, and by {@link #organs}, whose surfaces are added. */
    private TemplateMap placedBy(RoughAlignment rough, List<SurfacePair> pairs) {
        List<SharedStructure> kidneys = new ArrayList<>();
        for (SharedStructure s : organs) {
            if (s.organ().structure().name().startsWith(KIDNEY)) {
                kidneys.add(s);
            } else {
                if (s.kind() == StructureKind.ORGAN) {
                    rough.add(s);
                }
                pairs.add(s.pair(false));
            }
        }
        TemplateMap start = rough.align(pairs);
        // A breath moves the kidneys less than the liver: they tell where the back lies, not how high.
        for (SharedStructure kidney : kidneys) {
            SharedStructure level = kidney.atHeightOf(start);
            rough.add(level);
            pairs.add(level.pair(false));
        }
        return kidneys.isEmpty() ? start : rough.align(pairs);
    }

    /** The spine of a scan that has all vertebrae under one label, with that of the template. */
    private Optional<SurfacePair> wholeSpine() {
        Optional<PatientStructure> column = shared.stream().anyMatch(s -> s.kind() == StructureKind.VERTEBRA)
                ? Optional.empty()
                : body.structures().stream()
                        .filter(s -> s.structure().name().equals(LabelTable.SPINE))
                        .findFirst();
        return column.flatMap(s -> PatientBody.merged(rest.stream().filter(t -> t.kind() == StructureKind.VERTEBRA))
                .map(vertebrae -> new SurfacePair(s, s.structure().mesh(), vertebrae, true)));
    }

    private static Structure placed(Structure s, TemplateMap map) {
        return KEEPING_SHAPE.contains(s.kind()) ? similarity(s.mesh(), map).apply(s) : map.apply(s);
    }

    private static AffineTransform3D similarity(TriangleMesh mesh, TemplateMap map) {
        return AffineTransform3D.similarity(mesh.positions(), map.apply(mesh).positions());
    }

    /** The similarity that places all parts of a sternum that lies above the end of the scan. */
    private Optional<AffineTransform3D> unseenSternum(TemplateMap map) {
        return SharedStructure.belowSternum(shared).isEmpty()
                ? Optional.empty()
                : PatientBody.merged(rest.stream().filter(s -> s.kind() == StructureKind.STERNUM))
                        .map(mesh -> similarity(mesh, map));
    }

    /** @param continued names of the organs of the template that continue those which the scan truncates */
    private PatientBody completed(String templateName, Set<String> continued) {
        List<PatientStructure> all = new ArrayList<>();
        List<String> extended = new ArrayList<>();
        for (PatientStructure s : body.structures()) {
            Optional<DistanceSummary> off =
                    PatientBody.merged(template, s.structure()).map(mesh -> SurfacePair.distanceToScan(s, mesh));
            if (off.isEmpty() || partOf(s.structure()).isEmpty() || keepsCut(s.structure(), continued)) {
                all.add(extended(off.map(s::withDistanceToScan).orElse(s), extended));
            }
        }
        List<PatientStructure> kept = List.copyOf(all);
        int added = 0;
        for (Structure structure : template) {
            if (kept.stream().noneMatch(s -> s.structure().isSameAs(structure))) {
                Optional<PatientStructure> cut = partOf(structure);
                all.add(new PatientStructure(
                        structure,
                        continued.contains(structure.name())
                                ? PatientStructure.Source.EXTENDED
                                : PatientStructure.Source.VIRTUAL,
                        cut.flatMap(PatientStructure::scan),
                        cut.map(s -> SurfacePair.distanceToScan(
                                s, PatientBody.merged(template, s.structure()).orElseThrow()))));
                added += continued.contains(structure.name()) ? 0 : 1;
            }
        }
        all.sort(Comparator.comparing(s -> s.structure().name()));
        List<String> notes = new ArrayList<>(sizeNote.stream().toList());
        notes.add(Numbers.format(
                "%d structures come from %s, brought to the %d that it shares with the scan",
                added,
                templateName,
                Stream.concat(shared.stream(), organs.stream())
                        .map(s -> s.organ().structure().name())
                        .distinct()
                        .count()));
        if (!continued.isEmpty()) {
            notes.add("cut off by the scan, continued by " + templateName + " beyond its end: "
                    + String.join(", ", new TreeSet<>(continued)));
        }
        if (!extended.isEmpty()) {
            notes.add("ribs that end short of the spine, given neck and head: " + String.join(", ", extended));
        }
        List<String> lacking = ribs.stream()
                .filter(RibFit::lacksBack)
                .map(fit -> fit.shared().organ().structure().name())
                .toList();
        if (!lacking.isEmpty()) {
            notes.add(Numbers.format(
                    "ribs that end more than %.0f mm short of the spine, taken from %s: %s",
                    RibFit.LONGEST_NECK_MM, templateName, String.join(", ", lacking)));
        }
        return new PatientBody(body.name(), all, ExpectedStructures.missing(all), body.notes()).withNotes(notes);
    }

    /** What the scan shows of a structure that it truncates, or of a rib of which it lacks the back; else empty. */
    private Optional<PatientStructure> partOf(Structure s) {
        return body.firstCut(s).or(() -> ribs.stream()
                .filter(RibFit::lacksBack)
                .map(fit -> fit.shared().organ())
                .filter(rib -> rib.structure().isSameAs(s))
                .findFirst());
    }

    /**
     * Whether what the scan shows of a structure that it truncates is kept as it is: the end of a scan always cuts the
     * skin, and nothing continues vessels, muscles and bones outside the chest wall.
     */
    private static boolean keepsCut(Structure s, Set<String> continued) {
        return s.kind() == StructureKind.SKIN || (s.kind().isNamed() && !continued.contains(s.name()));
    }

    /** The rib with neck and head where it ends short of the spine, any other structure as it is. */
    private PatientStructure extended(PatientStructure s, List<String> names) {
        Optional<RibFit> rib = ribs.stream()
                .filter(fit -> fit.shared().organ().structure().isSameAs(s.structure()))
                .filter(fit -> fit.missingMm() > 0 && !fit.lacksBack())
                .findFirst();
        rib.ifPresent(
                fit -> names.add(Numbers.format("%s by %.0f mm", s.structure().name(), fit.missingMm())));
        return rib.map(fit -> s.extended(RibExtension.extended(fit))).orElse(s);
    }
}
