package org.phrenic.study.sweep;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Machines that round differently have different names. */
class RunMachineTest {
    private static List<String> arm(String... parts) {
        return List.of(parts).stream()
                .flatMap(part -> List.of(
                        "processor\t: 0",
                        "Features\t: fp asimd",
                        "CPU implementer\t: 0x41",
                        "CPU architecture: 8",
                        "CPU part\t: " + part,
                        "")
                        .stream())
                .toList();
    }

    @Test
    void processorsAreToldApartByTheirModelAndOnArmByTheirCodes() {
        List<String> intel =
                List.of("processor\t: 0", "model\t\t: 85", "model name\t: Intel(R) Xeon(R)", "CPU part\t: 1");
        assertThat(RunMachine.processor(intel)).contains("Intel(R) Xeon(R)");
        assertThat(RunMachine.processor(arm("0xd0c", "0xd0c"))).contains("CPU implementer 0x41, CPU part 0xd0c");
        assertThat(RunMachine.processor(arm("0xd40")))
                .isNotEqualTo(RunMachine.processor(arm("0xd0c")))
                .isPresent();
        assertThat(RunMachine.processor(arm("0xd46", "0xd40")))
                .as("whichever core comes first")
                .isEqualTo(RunMachine.processor(arm("0xd40", "0xd46")));
        assertThat(RunMachine.processor(List.of("processor\t: 0"))).isEmpty();
    }

    @Test
    void theTextNamesTheProgramBeforeJavaAndTheProcessorAfterIt() throws IOException {
        String text = RunMachine.text();
        String java = ", Java " + Runtime.version() + ", " + System.getProperty("os.arch") + ", ";
        assertThat(text).startsWith(RunMachine.program() + java);
        String processor = text.substring((RunMachine.program() + java).length());
        assertThat(processor).isNotBlank();
        Path cpuInfo = Path.of("/proc/cpuinfo");
        if (Files.isReadable(cpuInfo)) {
            RunMachine.processor(Files.readAllLines(cpuInfo))
                    .ifPresent(told -> assertThat(processor).isEqualTo(told));
        }
    }
}
