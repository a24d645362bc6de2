package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.patient.ExpectedStructures;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/** Gives a completed body the diaphragm that {@link DiaphragmBuilder} builds from its organs and bones. */
public final class DiaphragmCompletion {
    private static final String NAME = "diaphragm";

    private DiaphragmCompletion() {}

    /**
     * Replaces the diaphragm of a body, or adds one. A diaphragm that the scan labels as a whole, or that was built in
     * an earlier import, stays if it can breathe ({@link SheetQuality}). A body without ribs, lower thoracic vertebrae
     * or lungs is returned with a note. The part of a stomach in the chest ({@link HiatalHernia}) becomes an organ of
     * its own. Organs that lie elsewhere than the scan shows them yield to the sheet ({@link YieldToSheet}), as they do
     * in a scene.
     *
     * @param moved whether the body was brought to end-expiration, and none of its organs lies where the scan shows it
     * @param parted as {@link BreathLevel#parted}
     */
    public static PatientBody complete(PatientBody body, boolean moved, Optional<Side> parted) {
        return complete(body, moved, parted, Resolution.HIGH.diaphragmVertices());
    }

    /** The same with a sheet of about so many vertices. */
    static PatientBody complete(PatientBody body, boolean moved, Optional<Side> parted, int vertices) {
        if (hasUsable(body)) {
            return body;
        }
        List<PatientStructure> rest = new ArrayList<>(body.structures().stream()
                .filter(s -> s.structure().kind() != StructureKind.DIAPHRAGM)
                .toList());
        Thorax whole = bare(body, rest);
        MedianFrame frame = MedianFrame.of(whole);
        Structure sheet;
        Thorax straight;
        List<String> notes =
                new ArrayList<>(List.of("the diaphragm is built from the organs and bones that it touches"));
        try {
            Thorax before = frame.toFrame(whole);
            CageEnvelope cage = new CageEnvelope(before);
            Optional<HiatalHernia> hernia = showsBases(body) ? HiatalHernia.of(before, cage) : Optional.empty();
            hernia.ifPresent(found -> {
                part(rest, found, frame);
                notes.add(found.note());
            });
            Thorax bare = hernia.isPresent() ? bare(body, rest) : whole;
            straight = hernia.isPresent() ? frame.toFrame(bare) : before;
            Predicate<Structure> stays = s -> !moved && bare.isInScan(s);
            TriangleMesh built = DiaphragmBuilder.build(straight, cage, parted, stays, vertices);
            sheet = new Structure(NAME, StructureKind.DIAPHRAGM, 0, Side.MIDLINE, frame.toScan(built));
            YieldToSheet contact = new YieldToSheet(bare, frame, built);
            rest.replaceAll(s -> stays.test(s.structure()) ? s : s.withStructure(contact.yielded(s.structure())));
        } catch (IllegalArgumentException e) {
            return withoutTemplates(body).withNotes(List.of("no diaphragm is built: " + e.getMessage()));
        }
        rest.add(new PatientStructure(sheet, PatientStructure.Source.BUILT, Optional.empty(), Optional.empty()));
        rest.sort(Comparator.comparing(s -> s.structure().name()));
        UnequalBases.of(straight, parted).forEach(base -> base.note().ifPresent(notes::add));
        return new PatientBody(body.name(), rest, ExpectedStructures.missing(rest), body.notes()).withNotes(notes);
    }

    /** The body without a diaphragm. */
    private static Thorax bare(PatientBody body, List<PatientStructure> rest) {
        return new Thorax(
                body.name(),
                rest.stream().map(PatientStructure::structure).toList(),
                List.of(),
                body.thorax().notInScan());
    }

    /** Whether no lung is cut off below, so that its base is that of the scan. */
    private static boolean showsBases(PatientBody body) {
        return body.structures().stream()
                .filter(s -> s.structure().kind() == StructureKind.LUNG)
                .allMatch(s -> s.cuts().stream().noneMatch(cut -> cut.side().equals("I")));
    }

    /** Puts the parts of a stomach below and above the diaphragm in its place; both are of its label. */
    private static void part(List<PatientStructure> rest, HiatalHernia hernia, MedianFrame frame) {
        PatientStructure whole = rest.stream()
                .filter(s -> s.structure().name().equals(hernia.below().name()))
                .findFirst()
                .orElseThrow();
        rest.remove(whole);
        rest.add(whole.withStructure(inScan(hernia.below(), frame)));
        rest.add(whole.withStructure(inScan(hernia.above(), frame)));
    }

    private static Structure inScan(Structure s, MedianFrame frame) {
        return s.withMesh(frame.toScan(s.mesh()));
    }

    /** The same for a body whose lungs lie on the diaphragm, or of which organs show where it is. */
    public static PatientBody complete(PatientBody body, boolean moved) {
        return complete(body, moved, Optional.empty());
    }

    /** The body without the diaphragm of a template, which lies at none of its organs. */
    private static PatientBody withoutTemplates(PatientBody body) {
        List<PatientStructure> own = body.structures().stream()
                .filter(s -> s.structure().kind() != StructureKind.DIAPHRAGM
                        || s.source() != PatientStructure.Source.VIRTUAL)
                .toList();
        return new PatientBody(body.name(), own, ExpectedStructures.missing(own), body.notes());
    }

    private static boolean hasUsable(PatientBody body) {
        boolean own = body.structures().stream()
                .anyMatch(s -> s.structure().kind() == StructureKind.DIAPHRAGM
                        && s.source() != PatientStructure.Source.VIRTUAL
                        && s.isComplete());
        return own
                && SheetQuality.of(body.thorax())
                        .filter(q -> q.refusal().isEmpty())
                        .isPresent();
    }
}
