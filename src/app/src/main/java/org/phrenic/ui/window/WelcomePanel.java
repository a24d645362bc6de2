package org.phrenic.ui.window;

import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.phrenic.ui.session.Workspace;
import org.phrenic.ui.widget.Icons;
import org.phrenic.ui.widget.Theme;
import org.phrenic.ui.widget.WindowNotice;

/** What is seen first beside the breathing thorax: two doors, and what the program is not for. */
final class WelcomePanel extends JPanel {
    private final JLabel[] secondaryLabels;

    /**
     * @param enter told through which door someone went
     * @param dismiss called when the card is closed without
     */
    WelcomePanel(Consumer<Workspace> enter, Runnable dismiss) {
        super(new MigLayout("insets 8 12 8 8, gap 8 2, novisualpadding", "[0::, sg, fill][0::, sg, fill]push[]", ""));
        setName("welcome");
        getAccessibleContext().setAccessibleName("Welcome");
        JButton liver = workspaceButton(
                Workspace.CLINICIAN,
                "A needle to a target in a liver that moves with the breath, without terms of physics",
                enter);
        JButton tune = workspaceButton(Workspace.RESEARCHER, "Every parameter, force and plot", enter);
        JButton close = new JButton(Icons.CLOSE);
        close.putClientProperty("JButton.buttonType", "toolBarButton");
        close.setToolTipText("Close this card");
        close.getAccessibleContext().setAccessibleName("Close this card");
        close.addActionListener(e -> dismiss.run());
        JLabel underLiver = new JLabel("Needle, target, exercises, report card");
        JLabel underTune = new JLabel("Parameters, forces, live plots");
        JLabel notice = new JLabel(WindowNotice.TEXT);
        notice.setName("notice");
        notice.setFont(notice.getFont().deriveFont(java.awt.Font.BOLD));
        secondaryLabels = new JLabel[] {underLiver, underTune};
        add(liver, "wmin 0");
        add(tune, "wmin 0");
        add(close, "aligny top, wrap");
        add(underLiver, "gapx 2, wmin 0");
        add(underTune, "gapx 2, wmin 0, wrap");
        add(notice, "span 3, gapy 4 0, gapx 2, wmin 0");
        applyColours();
    }

    private static JButton workspaceButton(Workspace arrangement, String tip, Consumer<Workspace> enter) {
        JButton button = new JButton(arrangement.label());
        button.setName("door." + arrangement.name());
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(arrangement.label());
        button.putClientProperty("FlatLaf.styleClass", "h4");
        button.setMargin(new java.awt.Insets(8, 18, 8, 18));
        button.addActionListener(e -> enter.accept(arrangement));
        return button;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (secondaryLabels != null) {
            applyColours();
        }
    }

    private void applyColours() {
        setBackground(UIManager.getColor("Panel.background"));
        setBorder(BorderFactory.createMatteBorder(0, 0, 1, 0, Theme.borderColour()));
        for (JLabel label : secondaryLabels) {
            label.setForeground(Theme.secondaryText());
        }
    }
}
