package org.phrenic.study.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;

class SurfaceMissTest {
    private static final Thorax BODY = VirtualThorax.ofPreset("adult-male", Resolution.LOW);

    private static Structure shifted(Structure structure, double mm) {
        double[] p = structure.mesh().positions().clone();
        for (int i = 2; i < p.length; i += 3) {
            p[i] += mm;
        }
        return structure.withMesh(structure.mesh().withPositions(p));
    }

    private static Thorax liverShiftedBy(double mm) {
        List<Structure> livers = BODY.structuresOf(StructureKind.LIVER).stream()
                .map(liver -> shifted(liver, mm))
                .toList();
        return new Thorax("other", livers, List.of());
    }

    /** No point of a closed surface that is shifted is farther from it than the shift, and its top is that far. */
    @Test
    void aShiftedLiverIsOffByNoMoreThanTheShift() {
        assertThat(SurfaceMiss.of(BODY, liverShiftedBy(4))).singleElement().satisfies(miss -> {
            assertThat(miss.kind()).isEqualTo(StructureKind.LIVER);
            assertThat(miss.structures()).isOne();
            assertThat(miss.meanMm()).isBetween(1.0, 3.9);
            assertThat(miss.percentile95Mm()).isBetween(3.0, 4 + 1e-9);
        });
        assertThat(SurfaceMiss.of(BODY, liverShiftedBy(0)).get(0).meanMm()).isCloseTo(0, within(1e-9));
    }

    @Test
    void ofTwoRibsTheMeansAreAveragedAndTheWorseQuantileCounts() {
        List<Structure> ribs = BODY.structuresOf(StructureKind.RIB).subList(0, 2);
        Structure off = shifted(ribs.get(1), 4);
        SurfaceMiss alone = SurfaceMiss.of(BODY, new Thorax("other", List.of(off), List.of()))
                .get(0);
        assertThat(alone.meanMm()).isPositive();
        assertThat(SurfaceMiss.of(BODY, new Thorax("other", List.of(ribs.get(0), off), List.of())))
                .singleElement()
                .satisfies(both -> {
                    assertThat(both.kind()).isEqualTo(StructureKind.RIB);
                    assertThat(both.structures()).isEqualTo(2);
                    assertThat(both.meanMm()).isCloseTo(alone.meanMm() / 2, within(1e-9));
                    assertThat(both.percentile95Mm()).isCloseTo(alone.percentile95Mm(), within(1e-9));
                });
    }

    @Test
    void bodyWithoutACounterpartHasNothingToCompare() {
        assertThat(SurfaceMiss.of(BODY, new Thorax("other", List.of(), List.of())))
                .isEmpty();
    }
}
