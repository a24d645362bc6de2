package org.phrenic.patient;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;

/** The virtual woman, and the same with the cartilages under the names of their ribs. */
class RibPlausibilityTest {
    private static final Thorax WOMAN = VirtualThorax.ofPreset("adult-female", Resolution.LOW);

    private static Optional<String> note(Stream<Structure> structures) {
        return RibPlausibility.check(structures
                .map(s -> new PatientStructure(s, PatientStructure.Source.SCAN, Optional.empty(), Optional.empty()))
                .toList());
    }

    private static Stream<Structure> withoutCartilages() {
        return WOMAN.structures().stream().filter(s -> s.kind() != StructureKind.COSTAL_CARTILAGE);
    }

    /** Ribs of a side from a number on with their cartilages; the others end as bone. */
    private static Stream<Structure> grown(int first, Side... sides) {
        return withoutCartilages()
                .map(s -> s.kind() == StructureKind.RIB
                                && s.level() >= first
                                && List.of(sides).contains(s.side())
                        ? withCartilage(s)
                        : s);
    }

    private static Structure withCartilage(Structure rib) {
        return WOMAN.find(StructureKind.COSTAL_CARTILAGE, rib.level(), rib.side())
                .flatMap(cartilage -> PatientBody.merged(Stream.of(rib, cartilage)))
                .map(rib::withMesh)
                .orElse(rib);
    }

    @Test
    void ribsThatReachTheSternumHoldTheirCartilages() {
        assertThat(note(grown(1, Side.RIGHT, Side.LEFT)))
                .contains("no cartilages are labelled, and ribs 2 to 5 on the right and the left reach the sternum: the"
                        + " labels of these bones seem to hold the cartilages, which are bone then");
        assertThat(note(grown(2, Side.LEFT))).get().asString().contains("ribs 2 to 5 on the left reach");
    }

    @Test
    void ribsOfBoneOrBesideLabelledCartilagesAreNotRemarkedOn() {
        assertThat(note(withoutCartilages())).isEmpty();
        assertThat(note(WOMAN.structures().stream())).isEmpty();
        assertThat(note(grown(3, Side.RIGHT, Side.LEFT)))
                .as("the second are bone")
                .isEmpty();
        assertThat(note(Stream.concat(
                        grown(1, Side.RIGHT, Side.LEFT),
                        WOMAN.structuresOf(StructureKind.COSTAL_CARTILAGE).stream()
                                .limit(1))))
                .isEmpty();
        assertThat(note(grown(1, Side.RIGHT).filter(s -> s.kind() != StructureKind.STERNUM)))
                .isEmpty();
    }
}
