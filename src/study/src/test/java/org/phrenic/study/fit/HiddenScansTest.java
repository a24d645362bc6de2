package org.phrenic.study.fit;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class HiddenScansTest {
    @TempDir
    private Path folder;

    /** On a disk of another kind macOS puts such a file beside each of its own. */
    @Test
    void whatMacOsKeepsBesideAScanIsNoPatient() throws IOException {
        for (String name : List.of("a", "._a")) {
            for (String level : List.of("_expiration.nii.gz", "_inspiration.nii.gz")) {
                Files.createFile(folder.resolve(name + level));
            }
        }
        assertThat(PatientScans.findIn(folder)).extracting(PatientScans::name).containsExactly("a");
    }
}
