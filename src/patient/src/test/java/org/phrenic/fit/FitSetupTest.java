package org.phrenic.fit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.BoxBody;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.fit.search.FitParameter;
import org.phrenic.fit.search.FitSearch;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.material.Muscle;
import org.phrenic.scenario.Scenario;

/** What makes two fits one, so that one goes on from the evaluations of the other. */
class FitSetupTest {
    private static final Scenario BASE = Scenario.defaults();
    private static final TriangleMesh LUNG = BoxBody.box(60, 0, 150, 50);
    private static final FitParameter ACTIVATION = new FitParameter(Muscle.MUSCLE_ACTIVATION, 0.1, 0.8, 0.6);
    private static final FitSearch.Settings SEARCH = new FitSearch.Settings(1, 6, 0.2, 40, 60);

    private static Thorax body(List<Structure> structures, String... notInScan) {
        return new Thorax("patient", structures, List.of(), Set.of(notInScan));
    }

    private static Thorax bodyWithFirst(Structure first) {
        List<Structure> structures = new ArrayList<>(BoxBody.structures());
        structures.set(0, first);
        return body(structures);
    }

    private static FitSetup.Options options(FitHalf half, FitSearch.Settings search) {
        return new FitSetup.Options(half, "not aligned", search, 1, true);
    }

    private static String of(Scenario base, Thorax body, FitTarget target, FitParameter parameter) {
        return new FitSetup(base, body, List.of(target), List.of(parameter), options(FitHalf.ALL, SEARCH))
                .fingerprint();
    }

    private static String of(Thorax body) {
        return of(BASE, body, FitTarget.of(FitPart.LUNG_LEFT, LUNG), ACTIVATION);
    }

    private static String of(FitTarget target) {
        return of(BASE, body(BoxBody.structures()), target, ACTIVATION);
    }

    private static String of(FitSetup.Options options) {
        return new FitSetup(
                        BASE,
                        body(BoxBody.structures()),
                        List.of(FitTarget.of(FitPart.LUNG_LEFT, LUNG)),
                        List.of(ACTIVATION),
                        options)
                .fingerprint();
    }

    @Test
    void aFingerprintTellsFitsApart() {
        Structure rib = BoxBody.structures().get(0);
        TriangleMesh opened = new TriangleMesh(LUNG.positions(), new int[] {0, 2, 1, 1, 2, 3});
        double[] from = {1, 2, 3};
        double[] to = {1, 2, 4};
        assertThat(List.of(
                        of(body(BoxBody.structures())),
                        of(body(BoxBody.structures(), "diaphragm")),
                        of(bodyWithFirst(new Structure("rib_13_L", rib.kind(), rib.level(), rib.side(), rib.mesh()))),
                        of(bodyWithFirst(new Structure(rib.name(), rib.kind(), 2, rib.side(), rib.mesh()))),
                        of(bodyWithFirst(rib.withMesh(BoxBody.box(140, 0, 281, 10)))),
                        of(bodyWithFirst(
                                rib.withMesh(new TriangleMesh(rib.mesh().positions(), opened.triangles())))),
                        of(FitTarget.of(FitPart.LUNG_LEFT, BoxBody.box(60, 0, 151, 50))),
                        of(FitTarget.of(FitPart.LUNG_LEFT, opened)),
                        of(FitTarget.of(FitPart.LUNG_RIGHT, LUNG)),
                        of(FitTarget.of(FitPart.LUNG_LEFT, LUNG).withWeight(2)),
                        of(FitTarget.ofPointPairs(FitPart.LUNG_LEFT, from, to)),
                        of(FitTarget.ofPointPairs(FitPart.LUNG_LEFT, to, from)),
                        of(
                                BASE.with("muscle_stiffness_n_per_m=200"),
                                body(BoxBody.structures()),
                                FitTarget.of(FitPart.LUNG_LEFT, LUNG),
                                ACTIVATION),
                        of(
                                BASE,
                                body(BoxBody.structures()),
                                FitTarget.of(FitPart.LUNG_LEFT, LUNG),
                                new FitParameter(Muscle.MUSCLE_ACTIVATION, 0.1, 0.8, 0.5)),
                        of(options(FitHalf.EVEN, SEARCH)),
                        of(options(FitHalf.ALL, new FitSearch.Settings(2, 6, 0.2, 40, 60))),
                        of(options(FitHalf.ALL, new FitSearch.Settings(1, 7, 0.2, 40, 60))),
                        of(options(FitHalf.ALL, new FitSearch.Settings(1, 6, 0.3, 40, 60)))))
                .doesNotHaveDuplicates();
    }

    /** How long a search goes on, on how many threads, and what is reported of it, changes no evaluation. */
    @Test
    void aFingerprintIsThatOfTheSearchAlone() {
        assertThat(List.of(
                        of(options(FitHalf.ALL, SEARCH)),
                        of(options(FitHalf.ALL, new FitSearch.Settings(1, 6, 0.2, 80, 600))),
                        of(new FitSetup.Options(
                                FitHalf.ALL,
                                "aligned",
                                SEARCH,
                                2,
                                false,
                                Optional.of(new Landmarks(
                                        new double[] {1, 2, 3}, new double[] {1, 2, 3}, RigidMotion.identity())))),
                        of(
                                BASE.with("threads=2", "name=other"),
                                body(BoxBody.structures()),
                                FitTarget.of(FitPart.LUNG_LEFT, LUNG),
                                ACTIVATION)))
                .containsOnly(of(body(BoxBody.structures())));
    }
}
