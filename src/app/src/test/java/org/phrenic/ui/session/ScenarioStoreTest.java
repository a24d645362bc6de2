package org.phrenic.ui.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.document.YamlWriter;
import org.phrenic.engine.integrator.IntegratorKind;
import org.phrenic.file.BadInputException;
import org.phrenic.model.assembly.Breathing;
import org.phrenic.model.material.Materials;
import org.phrenic.model.material.RibRotation;
import org.phrenic.model.material.SheetSprings;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;

class ScenarioStoreTest {
    @TempDir
    Path folder;

    @Test
    void whatWasSavedComesBack() {
        ScenarioStore store = new ScenarioStore(folder.resolve("new"));
        assertThat(store.names()).isEmpty();
        Scenario stiff = Scenario.defaults().with("muscle_stiffness_n_per_m=450", "preset=deep", "rate_per_min=7");
        store.save("Stiff, deep", stiff);
        store.save("another", Scenario.defaults());
        assertThat(store.names()).containsExactly("another", "Stiff, deep");
        Scenario back = store.load("Stiff, deep");
        assertThat(back.name()).isEqualTo("Stiff, deep");
        assertThat(Assignment.liveChanges(back, stiff, "test"))
                .hasValueSatisfying(d -> assertThat(d).isEmpty());
        store.delete("another");
        assertThat(store.names()).containsExactly("Stiff, deep");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "  ", "../escape", "a/b", ".hidden", "what?", "Con", "aux.2", "a."})
    void aNameThatNoFileCanHaveIsRefused(String name) {
        ScenarioStore store = new ScenarioStore(folder);
        assertThatThrownBy(() -> store.save(name, Scenario.defaults()))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("name of settings: found '" + name + "'");
    }

    @Test
    void settingsLieWhereThePlatformKeepsAnApplicationsData() {
        Path home = Path.of("home");
        assertThat(ScenarioStore.folderOf("Linux", name -> null, home))
                .isEqualTo(home.resolve(".local/share/phrenic/settings"));
        Path data = folder.toAbsolutePath();
        assertThat(ScenarioStore.folderOf("Linux", Map.of("XDG_DATA_HOME", data.toString())::get, home))
                .isEqualTo(data.resolve("phrenic/settings"));
        assertThat(ScenarioStore.folderOf("Linux", Map.of("XDG_DATA_HOME", "data")::get, home))
                .as("else files would lie in the working folder")
                .isEqualTo(home.resolve(".local/share/phrenic/settings"));
        assertThat(ScenarioStore.folderOf("Mac OS X", name -> null, home))
                .isEqualTo(home.resolve("Library/Application Support/Phrenic/settings"));
        assertThat(ScenarioStore.folderOf("Windows 11", Map.of("APPDATA", "roaming")::get, home))
                .isEqualTo(Path.of("roaming/Phrenic/settings"));
    }

    @Test
    void anotherMaterialKeepsWhatItUses() {
        Scenario physical = Scenario.defaults()
                .with("muscle_stiffness_n_per_m=450", "rib_rotation=0.5", "rate_per_min=20", "resolution=low");
        Scenario paper = physical.withMaterial(Materials.PAPER);
        assertThat(paper.material()).isEqualTo(Materials.PAPER);
        assertThat(paper.states(SheetSprings.MUSCLE_STIFFNESS)).isFalse();
        assertThat(paper.get(RibRotation.RIB_ROTATION)).isEqualTo(0.5);
        assertThat(paper.get(Breathing.RATE)).isEqualTo(20);
        assertThat(paper.resolution()).isEqualTo(physical.resolution());
        // The step goes to that of the paper, 0.01 s, for the scenario stated none.
        assertThat(paper.timeStepS()).isEqualTo(0.01);
        assertThat(paper)
                .isEqualTo(Scenario.defaults()
                        .with("material=paper", "rib_rotation=0.5", "rate_per_min=20", "resolution=low"));
        assertThat(paper.withMaterial(Materials.PHYSICAL).timeStepS()).isEqualTo(0.00125);
    }

    /** A scenario that a run writes states every default of its material. */
    @Test
    void defaultsThatAreWrittenOutBecomeThoseOfAnotherMaterial() {
        Path written = folder.resolve("written.yaml");
        YamlWriter.write(written, Scenario.defaults().with("depth=0.8").toMap());
        Scenario published = Scenario.read(written).withMaterial(Materials.PUBLISHED);
        assertThat(published).isEqualTo(Scenario.defaults().with("material=published", "depth=0.8"));
        YamlWriter.write(written, Scenario.defaults().with("integrator=rk4").toMap());
        Scenario chosen = Scenario.read(written).withMaterial(Materials.PUBLISHED);
        assertThat(chosen.integrator()).isEqualTo(IntegratorKind.RK4);
        assertThat(chosen.timeStepS()).isEqualTo(0.01);
    }

    @Test
    void onlyWhatCanChangeWhileItBreathesIsALiveDifference() {
        Scenario quiet = Scenario.defaults();
        assertThat(Assignment.liveChanges(quiet, quiet.with("depth=1.2", "rate_per_min=20"), "test"))
                .hasValueSatisfying(
                        list -> assertThat(list).extracting("key").containsExactlyInAnyOrder("depth", "rate_per_min"));
        assertThat(Assignment.liveChanges(quiet, quiet.with("resolution=low"), "test"))
                .isEmpty();
    }
}
