<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>Neues Projekt…</translation>
    </message>
    <message>
        <source>Create a project from videos or connected cameras</source>
        <translation>Ein Projekt aus Videos oder angeschlossenen Kameras erstellen</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>Open a project file</source>
        <translation>Eine Projektdatei öffnen</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Demo öffnen</translation>
    </message>
    <message>
        <source>Open the simulated demo scene</source>
        <translation>Die simulierte Demo-Szene öffnen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save the changes to the project file</source>
        <translation>Die Änderungen in der Projektdatei speichern</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Das Projekt unter anderem Namen speichern</translation>
    </message>
    <message>
        <source>Close project</source>
        <translation>Projekt schließen</translation>
    </message>
    <message>
        <source>Go back to the start page</source>
        <translation>Zurück zur Startseite</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Quit Dewpoint</source>
        <translation>Dewpoint beenden</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Die letzte Änderung rückgängig machen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>Die zuletzt rückgängig gemachte Änderung wiederherstellen</translation>
    </message>
    <message>
        <source>Shortcuts…</source>
        <translation>Tastenkürzel…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>Track one frame and pause</source>
        <translation>Ein Bild verfolgen und anhalten</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>Eine Iteration</translation>
    </message>
    <message>
        <source>Run one filter iteration on the current frame and pause</source>
        <translation>Eine Filteriteration auf dem aktuellen Bild ausführen und anhalten</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Start the run again with the same random numbers</source>
        <translation>Den Lauf von vorn beginnen, mit denselben Zufallszahlen</translation>
    </message>
    <message>
        <source>Restart with a new seed</source>
        <translation>Mit neuem Startwert beginnen</translation>
    </message>
    <message>
        <source>Start the run again with other random numbers</source>
        <translation>Den Lauf von vorn beginnen, mit anderen Zufallszahlen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Show mask</source>
        <translation>Maske zeigen</translation>
    </message>
    <message>
        <source>Show which pixels have the color of a target</source>
        <translation>Zeigen, welche Pixel die Farbe eines Ziels haben</translation>
    </message>
    <message>
        <source>Show the room from above in the bird&apos;s-eye view (XY plane)</source>
        <translation>Den Raum in der Vogelperspektive von oben zeigen (XY-Ebene)</translation>
    </message>
    <message>
        <source>Show the room from the front in the bird&apos;s-eye view (XZ plane)</source>
        <translation>Den Raum in der Vogelperspektive von vorn zeigen (XZ-Ebene)</translation>
    </message>
    <message>
        <source>Search actions…</source>
        <translation>Aktionen suchen…</translation>
    </message>
    <message>
        <source>Find any action by its name</source>
        <translation>Jede Aktion nach ihrem Namen finden</translation>
    </message>
    <message>
        <source>Restore the default arrangement of the views</source>
        <translation>Die Standardanordnung der Ansichten wiederherstellen</translation>
    </message>
    <message>
        <source>Use the system&apos;s light or dark colors</source>
        <translation>Die hellen oder dunklen Farben des Systems verwenden</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Light colors</source>
        <translation>Helle Farben</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Dark colors</source>
        <translation>Dunkle Farben</translation>
    </message>
    <message>
        <source>Remove the target</source>
        <translation>Ziel entfernen</translation>
    </message>
    <message>
        <source>Remove the selected target from the project</source>
        <translation>Das gewählte Ziel aus dem Projekt entfernen</translation>
    </message>
    <message>
        <source>Learn the color</source>
        <translation>Farbe lernen</translation>
    </message>
    <message>
        <source>Click the target in a camera image to learn its color</source>
        <translation>Das Ziel in einem Kamerabild anklicken, um seine Farbe zu lernen</translation>
    </message>
    <message>
        <source>Add a target</source>
        <translation>Ziel hinzufügen</translation>
    </message>
    <message>
        <source>Track one more object: click it in a camera image</source>
        <translation>Ein weiteres Objekt verfolgen: Klicken Sie es in einem Kamerabild an</translation>
    </message>
    <message>
        <source>Export trajectory…</source>
        <translation>Bahn exportieren…</translation>
    </message>
    <message>
        <source>Export the trajectory so far for use in another program</source>
        <translation>Die bisherige Bahn für ein anderes Programm exportieren</translation>
    </message>
    <message>
        <source>Save a picture of a view…</source>
        <translation>Bild einer Ansicht speichern…</translation>
    </message>
    <message>
        <source>Save a camera image, the bird&apos;s-eye view or a plot as PNG</source>
        <translation>Ein Kamerabild, die Vogelschau oder eine Kurve als PNG speichern</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Voriges Bild</translation>
    </message>
    <message>
        <source>Step back one frame and show its tracking result</source>
        <translation>Das vorige Bild zeigen, wie es verfolgt wurde</translation>
    </message>
    <message>
        <source>Go to latest frame</source>
        <translation>Zum neuesten Bild</translation>
    </message>
    <message>
        <source>Stop looking back and show the latest tracked frame</source>
        <translation>Den Rückblick beenden und das zuletzt verfolgte Bild zeigen</translation>
    </message>
    <message>
        <source>Track again from here</source>
        <translation>Ab hier erneut verfolgen</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>Marke setzen</translation>
    </message>
    <message>
        <source>Add a named marker at the frame shown</source>
        <translation>Am gezeigten Bild eine benannte Marke setzen</translation>
    </message>
    <message>
        <source>Remove marker</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Remove the marker at the frame shown</source>
        <translation>Die Marke am gezeigten Bild entfernen</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>Vorige Marke</translation>
    </message>
    <message>
        <source>Go to the previous marker</source>
        <translation>Zur vorigen Marke gehen</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>Nächste Marke</translation>
    </message>
    <message>
        <source>Go to the next marker</source>
        <translation>Zur nächsten Marke gehen</translation>
    </message>
    <message>
        <source>Zoom to the selected time span</source>
        <translation>Auf die gewählte Zeitspanne zoomen</translation>
    </message>
    <message>
        <source>Show likelihood map</source>
        <translation>Likelihood-Karte zeigen</translation>
    </message>
    <message>
        <source>Show best particle</source>
        <translation>Bestes Partikel zeigen</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Plot spread</source>
        <translation>Streuung zeigen</translation>
    </message>
    <message>
        <source>Standard deviation of the particles along x, y and z</source>
        <translation>Standardabweichung der Partikel entlang x, y und z</translation>
    </message>
    <message>
        <source>Plot effective sample size</source>
        <translation>Effektive Stichprobengröße zeigen</translation>
    </message>
    <message>
        <source>Effective sample size, and number of particles</source>
        <translation>Effektive Stichprobengröße und Zahl der Partikel</translation>
    </message>
    <message>
        <source>Plot likelihood</source>
        <translation>Likelihood zeigen</translation>
    </message>
    <message>
        <source>How well the estimate fits each camera&apos;s image</source>
        <translation>Wie gut die Schätzung zum Bild jeder Kamera passt</translation>
    </message>
    <message>
        <source>Plot existence</source>
        <translation>Existenz zeigen</translation>
    </message>
    <message>
        <source>Existence probability: from all cameras together, and from each camera alone</source>
        <translation>Existenzwahrscheinlichkeit: aus allen Kameras zusammen und aus jeder allein</translation>
    </message>
    <message>
        <source>Plot error</source>
        <translation>Fehler zeigen</translation>
    </message>
    <message>
        <source>Distance between estimate and ground truth, if the truth is known</source>
        <translation>Abstand zwischen Schätzung und wahrer Position, falls diese bekannt ist</translation>
    </message>
    <message>
        <source>Plot time per step</source>
        <translation>Zeit pro Schritt zeigen</translation>
    </message>
    <message>
        <source>Plot over time</source>
        <translation>Über der Zeit auftragen</translation>
    </message>
    <message>
        <source>Plot against time in seconds instead of filter iterations</source>
        <translation>Über der Zeit in Sekunden statt über Filteriterationen auftragen</translation>
    </message>
    <message>
        <source>Show whole run</source>
        <translation>Ganzen Lauf zeigen</translation>
    </message>
    <message>
        <source>Show the whole run in the plots again (or double-click)</source>
        <translation>Wieder den ganzen Lauf in den Kurven zeigen (auch per Doppelklick)</translation>
    </message>
    <message>
        <source>Copy plots as CSV</source>
        <translation>Kurven als CSV kopieren</translation>
    </message>
    <message>
        <source>Copy the numbers of all plots shown, as a table</source>
        <translation>Die Zahlen der gezeigten Kurven als Tabelle kopieren</translation>
    </message>
    <message>
        <source>Save plots as picture…</source>
        <translation>Kurven als Bild speichern…</translation>
    </message>
    <message>
        <source>Copy trajectory as CSV</source>
        <translation>Bahn als CSV kopieren</translation>
    </message>
    <message>
        <source>Copy the selected rows of the trajectory, or all rows if none is selected</source>
        <translation>Die gewählten Zeilen der Bahn kopieren, oder alle, wenn keine gewählt ist</translation>
    </message>
    <message>
        <source>Calibrate by hand…</source>
        <translation>Von Hand kalibrieren…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Kalibrierung importieren…</translation>
    </message>
    <message>
        <source>Export calibration…</source>
        <translation>Kalibrierung exportieren…</translation>
    </message>
    <message>
        <source>Refine the calibration by waving a ball, or a wand with two balls</source>
        <translation>Die Kalibrierung verfeinern, indem Sie einen Ball oder einen Stab mit zwei Bällen schwenken</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Calibrate with a board…</source>
        <translation>Mit einer Tafel kalibrieren…</translation>
    </message>
    <message>
        <source>Find the intrinsics and positions of the cameras with a printed board</source>
        <translation>Intrinsische Parameter und Positionen der Kameras mit einer gedruckten Tafel bestimmen</translation>
    </message>
    <message>
        <source>Print a calibration board…</source>
        <translation>Kalibriertafel drucken…</translation>
    </message>
    <message>
        <source>Save the calibration board as a PDF at its true size</source>
        <translation>Die Kalibriertafel in wahrer Größe als PDF speichern</translation>
    </message>
    <message>
        <source>Plan the rig…</source>
        <translation>Den Aufbau planen…</translation>
    </message>
    <message>
        <source>See how accurately the cameras will measure, and where another camera would help</source>
        <translation>Sehen, wie genau die Kameras messen werden und wo eine weitere Kamera helfen würde</translation>
    </message>
    <message>
        <source>Show error map</source>
        <translation>Fehlerkarte zeigen</translation>
    </message>
    <message>
        <source>Add planned camera</source>
        <translation>Geplante Kamera hinzufügen</translation>
    </message>
    <message>
        <source>Add a planned camera; you can then drag it in the bird&apos;s-eye view to try out where to place it</source>
        <translation>Eine geplante Kamera hinzufügen; Sie können sie dann in der Vogelperspektive ziehen, um einen Platz für sie auszuprobieren</translation>
    </message>
    <message>
        <source>Recompute the pose of the camera that was moved during the run; all other cameras stay unchanged</source>
        <translation>Die Lage der Kamera neu berechnen, die während des Laufs bewegt wurde; alle anderen Kameras bleiben unverändert</translation>
    </message>
    <message>
        <source>Find best camera position</source>
        <translation>Beste Kameraposition suchen</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the position where another camera would help most</source>
        <translation>An Wänden und Decke die Position suchen, an der eine weitere Kamera am meisten helfen würde</translation>
    </message>
    <message>
        <source>Experiments…</source>
        <translation>Experimente …</translation>
    </message>
    <message>
        <source>Set box</source>
        <translation>Rahmen setzen</translation>
    </message>
    <message>
        <source>Export 3D shapes of people…</source>
        <translation>3D-Formen der Personen exportieren…</translation>
    </message>
    <message>
        <source>Save tables of each person&apos;s position, volume, hull and density on the floor</source>
        <translation>Tabellen mit Position, Volumen, Hülle und Dichte auf dem Boden für jede Person speichern</translation>
    </message>
    <message>
        <source>Add person…</source>
        <translation>Person hinzufügen…</translation>
    </message>
    <message>
        <source>Click the person in a camera image, or the floor in the bird&apos;s-eye view</source>
        <translation>Klicken Sie die Person in einem Kamerabild an, oder den Boden in der Vogelperspektive</translation>
    </message>
    <message>
        <source>Remove person</source>
        <translation>Person entfernen</translation>
    </message>
    <message>
        <source>Remove the person selected in the table</source>
        <translation>Die in der Tabelle gewählte Person entfernen</translation>
    </message>
    <message>
        <source>Show 3D shapes of people</source>
        <translation>3D-Formen der Personen zeigen</translation>
    </message>
    <message>
        <source>Filter threads…</source>
        <translation>Filter-Threads…</translation>
    </message>
    <message>
        <source>Choose how many processor threads compute the filter</source>
        <translation>Wählen, wie viele Prozessor-Threads den Filter berechnen</translation>
    </message>
    <message>
        <source>Correct position</source>
        <translation>Position korrigieren</translation>
    </message>
    <message>
        <source>Drag a target in the camera images to its true position in this frame; tracking continues from there</source>
        <translation>Ein Ziel in den Kamerabildern an seine wahre Position in diesem Bild ziehen; von dort wird weiter verfolgt</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>Korrektur entfernen</translation>
    </message>
    <message>
        <source>Remove the correction of the selected target in this frame, or of all targets if none is selected</source>
        <translation>Die Korrektur des gewählten Ziels in diesem Bild entfernen, oder aller Ziele, wenn keines gewählt ist</translation>
    </message>
    <message>
        <source>Show the volume of interest</source>
        <translation>Den Suchraum zeigen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Track again</source>
        <translation>Erneut verfolgen</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Normal speed</source>
        <translation>Normale Geschwindigkeit</translation>
    </message>
    <message>
        <source>Play the recording as fast as it was filmed</source>
        <translation>Die Aufnahme so schnell abspielen, wie sie gefilmt wurde</translation>
    </message>
    <message>
        <source>Play slowly until converged</source>
        <translation>Langsam abspielen bis zur Konvergenz</translation>
    </message>
    <message>
        <source>Show magnifier</source>
        <translation>Lupe zeigen</translation>
    </message>
    <message>
        <source>Show lines of sight</source>
        <translation>Sichtlinien zeigen</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom in on the camera image under the pointer, or on the image of the selected camera (or use the mouse wheel)</source>
        <translation>In das Kamerabild unter dem Mauszeiger hineinzoomen, oder in das der gewählten Kamera (auch mit dem Mausrad)</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Zoom out of the camera image under the pointer, or of the image of the selected camera</source>
        <translation>Aus dem Kamerabild unter dem Mauszeiger herauszoomen, oder aus dem der gewählten Kamera</translation>
    </message>
    <message>
        <source>Fit image</source>
        <translation>Bild einpassen</translation>
    </message>
    <message>
        <source>Show the whole camera image (or double-click)</source>
        <translation>Das ganze Kamerabild zeigen (auch per Doppelklick)</translation>
    </message>
    <message>
        <source>Top view</source>
        <translation>Ansicht von oben</translation>
    </message>
    <message>
        <source>Front view</source>
        <translation>Ansicht von vorn</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Fit everything in view</source>
        <translation>Alles einpassen</translation>
    </message>
    <message>
        <source>Show the whole room in the bird&apos;s-eye view (or double-click)</source>
        <translation>Den ganzen Raum in der Vogelperspektive zeigen (auch per Doppelklick)</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Switch between full screen and a normal window</source>
        <translation>Zwischen Vollbild und normalem Fenster wechseln</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Plot position</source>
        <translation>Position zeigen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Open the manual at the page about the active view</source>
        <translation>Das Handbuch auf der Seite zur aktiven Ansicht öffnen</translation>
    </message>
    <message>
        <source>Quick start</source>
        <translation>Schnelleinstieg</translation>
    </message>
    <message>
        <source>What you see in the window, and how to begin in five steps</source>
        <translation>Was im Fenster zu sehen ist und wie man in fünf Schritten beginnt</translation>
    </message>
    <message>
        <source>Legend of the overlays</source>
        <translation>Legende der Einblendungen</translation>
    </message>
    <message>
        <source>What crosses, ellipses and dots in the images mean</source>
        <translation>Was Kreuze, Ellipsen und Punkte in den Bildern bedeuten</translation>
    </message>
    <message>
        <source>About the methods</source>
        <translation>Über die Verfahren</translation>
    </message>
    <message>
        <source>Open the reference of the tracking methods</source>
        <translation>Die Referenz der Verfahren zum Verfolgen öffnen</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Problem melden…</translation>
    </message>
    <message>
        <source>Collect the information that a bug report needs, ready to copy</source>
        <translation>Die Angaben für einen Fehlerbericht sammeln, fertig zum Kopieren</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Über Dewpoint</translation>
    </message>
    <message>
        <source>Version, license, and how to cite Dewpoint</source>
        <translation>Version, Lizenz und wie Dewpoint zitiert wird</translation>
    </message>
    <message>
        <source>Show images in the bird&apos;s-eye view</source>
        <translation>Bilder in der Vogelperspektive zeigen</translation>
    </message>
    <message>
        <source>Show each camera&apos;s image inside its viewing pyramid in the bird&apos;s-eye view</source>
        <translation>In der Vogelperspektive das Bild jeder Kamera in ihrer Sichtpyramide zeigen</translation>
    </message>
    <message>
        <source>Set floor and origin…</source>
        <translation>Boden und Ursprung festlegen …</translation>
    </message>
    <message>
        <source>Calibrate…</source>
        <translation>Kalibrieren…</translation>
    </message>
    <message>
        <source>See what is known about the cameras, and calibrate them step by step in the way that you choose</source>
        <translation>Sehen, was über die Kameras bekannt ist, und sie auf dem gewählten Weg Schritt für Schritt kalibrieren</translation>
    </message>
    <message>
        <source>Play the first iterations of a run one by one, until every target is being tracked (five seconds at most)</source>
        <translation>Die ersten Iterationen eines Laufs einzeln abspielen, bis jedes Ziel verfolgt wird (höchstens fünf Sekunden)</translation>
    </message>
    <message>
        <source>See and change all keyboard shortcuts</source>
        <translation>Alle Tastenkürzel sehen und ändern</translation>
    </message>
    <message>
        <source>Adjust the calibration of the cameras until a grid drawn over their images matches the real scene</source>
        <translation>Die Kalibrierung der Kameras einstellen, bis ein über ihre Bilder gezeichnetes Gitter zur wirklichen Szene passt</translation>
    </message>
    <message>
        <source>Set the floor, the origin, the axes and the scale of the room with points that you mark in the images</source>
        <translation>Boden, Ursprung, Achsen und Maßstab des Raums mit Punkten festlegen, die Sie in den Bildern markieren</translation>
    </message>
    <message>
        <source>Load the calibration of the cameras from a file that another program wrote</source>
        <translation>Die Kalibrierung der Kameras aus einer Datei laden, die ein anderes Programm geschrieben hat</translation>
    </message>
    <message>
        <source>Save the calibration of the cameras for another program</source>
        <translation>Die Kalibrierung der Kameras für ein anderes Programm speichern</translation>
    </message>
    <message>
        <source>In the bird&apos;s-eye view, show the position error to expect for a target at each point</source>
        <translation>In der Vogelperspektive zeigen, welcher Positionsfehler für ein Ziel an jedem Punkt zu erwarten ist</translation>
    </message>
    <message>
        <source>Track again from the frame shown, with the current method, parameters and colors. To stop, press Pause</source>
        <translation>Ab dem gezeigten Bild erneut verfolgen, mit dem aktuellen Verfahren und den aktuellen Parametern und Farben. Zum Beenden „Pause“ drücken</translation>
    </message>
    <message>
        <source>Track again every frame that was last tracked with earlier settings</source>
        <translation>Alle Bilder erneut verfolgen, die zuletzt mit früheren Einstellungen verfolgt wurden</translation>
    </message>
    <message>
        <source>Play the recording more slowly, down to 1/30 of the normal speed</source>
        <translation>Die Aufnahme langsamer abspielen, bis hinab zu 1/30 der normalen Geschwindigkeit</translation>
    </message>
    <message>
        <source>Play the recording faster, up to eight times the normal speed</source>
        <translation>Die Aufnahme schneller abspielen, bis zur achtfachen normalen Geschwindigkeit</translation>
    </message>
    <message>
        <source>Fill the timeline with the selected span of the recording</source>
        <translation>Die Zeitleiste mit der gewählten Spanne der Aufnahme füllen</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Record the live cameras into a folder that opens as a project, or stop recording</source>
        <translation>Die Livekameras in einen Ordner aufnehmen, der sich als Projekt öffnen lässt, oder die Aufnahme beenden</translation>
    </message>
    <message>
        <source>Send results</source>
        <translation>Ergebnisse senden</translation>
    </message>
    <message>
        <source>Start or stop sending positions to other programs during the run. Until you start sending, nothing is sent</source>
        <translation>Positionen während des Laufs an andere Programme senden, oder das Senden beenden. Solange Sie das Senden nicht starten, wird nichts gesendet</translation>
    </message>
    <message>
        <source>Outputs…</source>
        <translation>Ausgänge…</translation>
    </message>
    <message>
        <source>Choose where results are sent: TCP, WebSocket, OSC, TUIO, CSV</source>
        <translation>Wählen, wohin Ergebnisse gesendet werden: TCP, WebSocket, OSC, TUIO, CSV</translation>
    </message>
    <message>
        <source>Reproduce figures from the papers that describe the methods, and write a report</source>
        <translation>Abbildungen der Artikel, die die Verfahren beschreiben, reproduzieren und einen Bericht schreiben</translation>
    </message>
    <message>
        <source>Show how likely each position around the target is. Circles mark positions at which the method suspects the target</source>
        <translation>Zeigen, wie wahrscheinlich jede Position um das Ziel ist. Kreise markieren Positionen, an denen das Verfahren das Ziel vermutet</translation>
    </message>
    <message>
        <source>In all views, draw a triangle at the particle of each target that has the highest weight</source>
        <translation>In allen Ansichten ein Dreieck an dem Partikel jedes Ziels zeichnen, das das höchste Gewicht hat</translation>
    </message>
    <message>
        <source>When a target&apos;s particles are too close together to tell apart, show them enlarged</source>
        <translation>Wenn die Partikel eines Ziels so dicht beieinander liegen, dass man sie nicht unterscheiden kann, sie vergrößert zeigen</translation>
    </message>
    <message>
        <source>In the bird&apos;s-eye view, draw a line from each camera to the target. The line is dashed if the camera cannot see the target</source>
        <translation>In der Vogelperspektive eine Linie von jeder Kamera zum Ziel zeichnen. Die Linie ist gestrichelt, wenn die Kamera das Ziel nicht sieht</translation>
    </message>
    <message>
        <source>Draw the volume of interest in the images and in the bird&apos;s-eye view: targets are searched for only inside this box</source>
        <translation>Den Suchraum in den Bildern und in der Vogelperspektive zeichnen: Ziele werden nur in diesem Quader gesucht</translation>
    </message>
    <message>
        <source>Show the hull that encloses 95 % of each person&apos;s volume, and lines on the floor around the areas that contain 25, 50, 75 and 95 % of each person</source>
        <translation>Die Hülle zeigen, die 95 % des Volumens jeder Person umschließt, und Linien auf dem Boden um die Flächen, die 25, 50, 75 und 95 % jeder Person enthalten</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view in perspective; drag to rotate it</source>
        <translation>Vogelperspektive in Perspektive; zum Drehen ziehen</translation>
    </message>
    <message>
        <source>Position along x, y and z, with a band of plus and minus two standard deviations, and the true position if it is known</source>
        <translation>Position entlang x, y und z, mit einem Band von plus und minus zwei Standardabweichungen, und die wahre Position, wenn sie bekannt ist</translation>
    </message>
    <message>
        <source>Time that one filter iteration takes for one target, in microseconds</source>
        <translation>Zeit, die eine Filteriteration für ein Ziel braucht, in Mikrosekunden</translation>
    </message>
    <message>
        <source>Save a picture of the plots as they look now, as SVG or PNG</source>
        <translation>Die Kurven so, wie sie jetzt aussehen, als SVG oder PNG speichern</translation>
    </message>
    <message>
        <source>Check project…</source>
        <translation>Projekt prüfen…</translation>
    </message>
    <message>
        <source>Check the recordings, times, calibration, colors and method of the project for problems</source>
        <translation>Aufnahmen, Zeiten, Kalibrierung, Farben und Verfahren des Projekts auf Probleme prüfen</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>Kameras…</translation>
    </message>
    <message>
        <source>Add, remove, replace and adjust the cameras of the project</source>
        <translation>Die Kameras des Projekts hinzufügen, entfernen, ersetzen und einstellen</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>Farben sperren</translation>
    </message>
    <message>
        <source>Switch off the automatic exposure, gain and white balance of all connected cameras, and keep the current values</source>
        <translation>Belichtung, Verstärkung und Weißabgleich aller angeschlossenen Kameras nicht mehr automatisch regeln und die jetzigen Werte behalten</translation>
    </message>
    <message>
        <source>Export video…</source>
        <translation>Video exportieren …</translation>
    </message>
    <message>
        <source>Save the camera views and the bird&apos;s-eye view as a video</source>
        <translation>Die Kameraansichten und die Vogelperspektive als Video speichern</translation>
    </message>
    <message>
        <source>Set take number and notes…</source>
        <translation>Nummer und Notizen der Aufnahme …</translation>
    </message>
    <message>
        <source>Set the number and notes of the next take, or the notes of the current take</source>
        <translation>Nummer und Notizen der nächsten Aufnahme oder Notizen der laufenden festlegen</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Read the messages of this window again, with their times, and copy them</source>
        <translation>Die Meldungen dieses Fensters mit ihren Uhrzeiten noch einmal lesen und kopieren</translation>
    </message>
    <message>
        <source>Go to frame…</source>
        <translation>Zu Bild gehen…</translation>
    </message>
    <message>
        <source>Enter a frame number, or a time such as 2.5 s, and go there</source>
        <translation>Eine Bildnummer oder eine Zeit wie 2,5 s eingeben und dorthin gehen</translation>
    </message>
    <message>
        <source>Previous trouble</source>
        <translation>Vorige Störung</translation>
    </message>
    <message>
        <source>Go back to the frame where tracking of the selected target was lost or became uncertain, or where a camera had a problem. If no target is selected, all targets count</source>
        <translation>Zurück zu dem Bild gehen, in dem das ausgewählte Ziel verloren oder unsicher wurde oder eine Kamera ein Problem hatte. Ist kein Ziel ausgewählt, zählen alle Ziele</translation>
    </message>
    <message>
        <source>Next trouble</source>
        <translation>Nächste Störung</translation>
    </message>
    <message>
        <source>Go to the next frame where tracking of the selected target is lost or becomes uncertain, or where a camera has a problem. If no target is selected, all targets count</source>
        <translation>Zum nächsten Bild gehen, in dem das ausgewählte Ziel verloren oder unsicher wird oder eine Kamera ein Problem hat. Ist kein Ziel ausgewählt, zählen alle Ziele</translation>
    </message>
    <message>
        <source>Side view</source>
        <translation>Ansicht von der Seite</translation>
    </message>
    <message>
        <source>Show the room from the side in the bird&apos;s-eye view (YZ plane)</source>
        <translation>Den Raum in der Vogelperspektive von der Seite zeigen (YZ-Ebene)</translation>
    </message>
    <message>
        <source>Hide or show the target</source>
        <translation>Ziel aus- oder einblenden</translation>
    </message>
    <message>
        <source>Hide the selected target in the images and in the bird&apos;s-eye view, or show it again. A hidden target is still tracked</source>
        <translation>Das gewählte Ziel in den Bildern und in der Vogelperspektive ausblenden oder wieder einblenden. Auch ein ausgeblendetes Ziel wird verfolgt</translation>
    </message>
    <message>
        <source>Calibrate with a wand…</source>
        <translation>Mit einem Kalibrierstab kalibrieren…</translation>
    </message>
    <message>
        <source>Recompute pose of moved camera</source>
        <translation>Lage der bewegten Kamera neu berechnen</translation>
    </message>
</context>
<context>
    <name>AssessedRegions</name>
    <message>
        <source>also has the target&apos;s color</source>
        <translation>hat auch die Farbe des Ziels</translation>
    </message>
    <message>
        <source>recognized as the target (if this is wrong, Ctrl+Shift-click here)</source>
        <translation>als Ziel erkannt (falls das nicht stimmt: Strg+Umschalt+Klick hier)</translation>
    </message>
    <message>
        <source>some pixels also have the target&apos;s color</source>
        <translation>einige Pixel haben auch die Farbe des Ziels</translation>
    </message>
</context>
<context>
    <name>BoardText</name>
    <message>
        <source>The board&apos;s corners cover only %1 % of the image: show the board in every part of the image, and tilt it too.</source>
        <translation>Die Ecken der Tafel decken nur %1 % des Bildes ab: Zeigen Sie die Tafel in jedem Teil des Bildes, und neigen Sie sie auch.</translation>
    </message>
    <message>
        <source>%1 keeps its position because it never saw the board.</source>
        <translation>%1 behält ihre Position, weil sie die Tafel nie gesehen hat.</translation>
    </message>
    <message>
        <source>Intrinsics</source>
        <translation>Intrinsische Parameter</translation>
    </message>
    <message>
        <source>The intrinsics of %1 are unchanged: %2</source>
        <translation>Die intrinsischen Parameter von %1 bleiben unverändert: %2</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>center</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>left side closer to the camera</source>
        <translation>linke Seite näher zur Kamera</translation>
    </message>
    <message>
        <source>right side closer to the camera</source>
        <translation>rechte Seite näher zur Kamera</translation>
    </message>
    <message>
        <source>upper side closer to the camera</source>
        <translation>obere Seite näher zur Kamera</translation>
    </message>
    <message>
        <source>lower side closer to the camera</source>
        <translation>untere Seite näher zur Kamera</translation>
    </message>
    <message>
        <source>facing the camera</source>
        <translation>zur Kamera gewandt</translation>
    </message>
    <message>
        <source>No image yet</source>
        <translation>Noch kein Bild</translation>
    </message>
    <message>
        <source>Show the whole board</source>
        <translation>Die ganze Tafel zeigen</translation>
    </message>
    <message>
        <source>Move the board to: %1</source>
        <translation>Tafel bewegen nach: %1</translation>
    </message>
    <message>
        <source>Turn the board: %1</source>
        <translation>Tafel ausrichten: %1</translation>
    </message>
    <message>
        <source>Move the board closer</source>
        <translation>Tafel näher bringen</translation>
    </message>
    <message>
        <source>Hold the board still</source>
        <translation>Tafel still halten</translation>
    </message>
    <message>
        <source>The image is blurred: focus the lens or add light</source>
        <translation>Das Bild ist unscharf: scharf stellen oder mehr Licht geben</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ Fertig</translation>
    </message>
    <message>
        <source>✓ The cameras share enough views of the board</source>
        <translation>✓ Die Kameras haben genug gemeinsame Ansichten der Tafel</translation>
    </message>
    <message>
        <source>Show the board to %1 and %2 at the same time, hold it still, then repeat elsewhere</source>
        <translation>Zeigen Sie die Tafel %1 und %2 zugleich, halten Sie sie still, und wiederholen Sie das anderswo</translation>
    </message>
    <message>
        <source>board not visible</source>
        <translation>keine Tafel zu sehen</translation>
    </message>
    <message>
        <source>⚠ blurred: edges are %1 wide</source>
        <translation>⚠ unscharf: Kanten sind %1 breit</translation>
    </message>
    <message>
        <source>sharp: edges are %1 wide</source>
        <translation>scharf: Kanten sind %1 breit</translation>
    </message>
    <message>
        <source>%1 views, accuracy %2 (goal: %3)</source>
        <translation>%1 Ansichten, Genauigkeit %2 (Ziel: %3)</translation>
    </message>
    <message>
        <source>● board visible</source>
        <translation>● Tafel sichtbar</translation>
    </message>
    <message>
        <source>○ board not visible</source>
        <translation>○ Tafel nicht sichtbar</translation>
    </message>
    <message>
        <source>%1 views, position accuracy %2</source>
        <translation>%1 Ansichten, Positionsgenauigkeit %2</translation>
    </message>
    <message>
        <source>%1 views shared with other cameras</source>
        <translation>%1 gemeinsame Ansichten mit anderen Kameras</translation>
    </message>
    <message>
        <source>The camera positions could not be computed: %1</source>
        <translation>Die Kamerapositionen konnten nicht berechnet werden: %1</translation>
    </message>
    <message>
        <source>The accuracy cannot be estimated, because two cameras rarely saw the board at the same time.</source>
        <translation>Die Genauigkeit lässt sich nicht schätzen, weil zwei Kameras die Tafel zu selten gleichzeitig sahen.</translation>
    </message>
    <message>
        <source>a chessboard with %1 × %2 inner corners</source>
        <translation>ein Schachbrett mit %1 × %2 inneren Ecken</translation>
    </message>
    <message>
        <source>a ChArUco board with %1 × %2 squares, %3</source>
        <translation>eine ChArUco-Tafel mit %1 × %2 Feldern, %3</translation>
    </message>
    <message>
        <source>legacy layout</source>
        <translation>altes Layout</translation>
    </message>
    <message>
        <source>%1: RMS reprojection error %2, focal length %3, accuracy of the intrinsics %5, from %4 images</source>
        <translation>%1: RMS-Rückprojektionsfehler %2, Brennweite %3, Genauigkeit der intrinsischen Parameter %5, aus %4 Bildern</translation>
    </message>
    <message>
        <source>%1: RMS reprojection error %2, position ±%3, direction ±%4</source>
        <translation>%1: RMS-Rückprojektionsfehler %2, Position ±%3, Richtung ±%4</translation>
    </message>
    <message>
        <source>%1: RMS reprojection error %2</source>
        <translation>%1: RMS-Rückprojektionsfehler %2</translation>
    </message>
    <message>
        <source>Camera positions: RMS reprojection error %1, from %2 board poses</source>
        <translation>Kamerapositionen: RMS-Rückprojektionsfehler %1, aus %2 Lagen der Tafel</translation>
    </message>
    <message>
        <source>%1 views; at least %2 are needed</source>
        <translation>%1 Ansichten; mindestens %2 sind nötig</translation>
    </message>
    <message>
        <source>inverted colors</source>
        <translation>Farben umgekehrt</translation>
    </message>
    <message>
        <source>%1 of the %2 searched images show %3, but mirrored. To correct this, change “Mirrored” in the panel Cameras for the cameras that took these images. Use this board?</source>
        <translation>%1 der %2 durchsuchten Bilder zeigen %3, aber gespiegelt. Ändern Sie dazu „Gespiegelt“ im Bereich „Kameras“ für die Kameras, die diese Bilder aufgenommen haben. Diese Tafel verwenden?</translation>
    </message>
    <message>
        <source>%1 of the %2 searched images show %3. Use this board?</source>
        <translation>%1 der %2 durchsuchten Bilder zeigen %3. Diese Tafel verwenden?</translation>
    </message>
    <message>
        <source>%1 (too few corners: %2)</source>
        <translation>%1 (zu wenige Ecken: %2)</translation>
    </message>
    <message>
        <source>%1 (blurred: edges are %2 wide)</source>
        <translation>%1 (unscharf: Kanten sind %2 breit)</translation>
    </message>
    <message>
        <source>%1 (too small: squares are only %2 wide)</source>
        <translation>%1 (zu klein: Felder sind nur %2 breit)</translation>
    </message>
    <message>
        <source>%1: no board was found in frames %2.</source>
        <translation>%1: In den Einzelbildern %2 wurde keine Tafel gefunden.</translation>
    </message>
    <message>
        <source>%1: no board was found in frames %2 and in %3 others.</source>
        <translation>%1: In den Einzelbildern %2 und in %3 weiteren wurde keine Tafel gefunden.</translation>
    </message>
    <message>
        <source>The video of %1 is mirrored: it shows the board mirrored, but another camera shows the board the right way round.</source>
        <translation>Das Video von %1 ist gespiegelt: Es zeigt die Tafel gespiegelt, eine andere Kamera zeigt sie seitenrichtig.</translation>
    </message>
    <message>
        <source>The board or the video of %1 is mirrored: no camera shows the board the right way round. Check whether writing in the images is readable.</source>
        <translation>Die Tafel oder das Video von %1 ist gespiegelt: Keine Kamera zeigt die Tafel seitenrichtig. Prüfen Sie, ob Schrift in den Bildern lesbar ist.</translation>
    </message>
</context>
<context>
    <name>CalibrationFiles</name>
    <message>
        <source>Calibrations (%1)</source>
        <translation>Kalibrierungen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>CalibrationText</name>
    <message>
        <source>The images of %1 are %2 times as large as those for which it was calibrated: its intrinsics are for another resolution. Convert the intrinsics, or record at the calibrated size.</source>
        <translation>Die Bilder von %1 sind %2-mal so groß wie die, für die sie kalibriert wurde: Ihre intrinsischen Parameter gelten für eine andere Auflösung. Rechnen Sie die Parameter um, oder nehmen Sie in der kalibrierten Größe auf.</translation>
    </message>
    <message>
        <source>all cameras</source>
        <translation>alle Kameras</translation>
    </message>
    <message>
        <source>All cameras seem to see the board from behind, or the floor from below: the measured points are probably mirrored. Check the direction of the axes, and make sure that the printed board is not mirrored.</source>
        <translation>Alle Kameras sehen anscheinend die Tafel von hinten oder den Boden von unten: Die gemessenen Punkte sind wahrscheinlich gespiegelt. Prüfen Sie die Richtung der Achsen, und ob die Tafel nicht seitenverkehrt gedruckt ist.</translation>
    </message>
    <message>
        <source>Everything fits when %1 and %2 are exchanged: their videos are probably swapped. Exchange the two files.</source>
        <translation>Alles passt, wenn %1 und %2 vertauscht werden: wahrscheinlich sind ihre Videos verwechselt. Tauschen Sie die beiden Dateien.</translation>
    </message>
    <message>
        <source>%1 agrees with the other cameras only if its video is shifted in time: the video is probably %2 frames late. Synchronize the videos, or calibrate with a wand and turn on “Find delays”.</source>
        <translation>%1 stimmt nur dann mit den anderen Kameras überein, wenn ihr Video zeitlich verschoben wird: Es ist wahrscheinlich %2 Bilder zu spät. Synchronisieren Sie die Videos, oder kalibrieren Sie mit dem Stab, und schalten Sie „Verzögerungen suchen“ ein.</translation>
    </message>
    <message>
        <source>%1 agrees with the other cameras only if its video is shifted in time: the video is probably %2 frames early. Synchronize the videos, or calibrate with a wand and turn on “Find delays”.</source>
        <translation>%1 stimmt nur dann mit den anderen Kameras überein, wenn ihr Video zeitlich verschoben wird: Es ist wahrscheinlich %2 Bilder zu früh. Synchronisieren Sie die Videos, oder kalibrieren Sie mit dem Stab, und schalten Sie „Verzögerungen suchen“ ein.</translation>
    </message>
    <message>
        <source>The images of %1 fit one pose before %2 and another pose after that time: the camera was probably moved. Calibrate with the later part of the recording only.</source>
        <translation>Die Bilder von %1 passen vor %2 zu einer Lage und danach zu einer anderen: Die Kamera wurde wahrscheinlich bewegt. Kalibrieren Sie nur mit dem späteren Teil der Aufnahme.</translation>
    </message>
    <message>
        <source>The images of %1 fit only if they are flipped: the video is probably mirrored or upside down. Set the rotation and mirroring of these images.</source>
        <translation>Die Bilder von %1 passen nur, wenn sie umgekehrt werden: Das Video ist wahrscheinlich gespiegelt oder steht auf dem Kopf. Stellen Sie Drehung und Spiegelung dieser Bilder ein.</translation>
    </message>
    <message>
        <source>The images of %1 fit a focal length that is %2 times the one in its calibration: the zoom or crop of the camera was probably changed. Calibrate its intrinsics again.</source>
        <translation>Die Bilder von %1 passen zum %2-fachen der kalibrierten Brennweite: Wahrscheinlich wurde der Zoom oder der Ausschnitt der Kamera geändert. Kalibrieren Sie ihre intrinsischen Parameter neu.</translation>
    </message>
    <message>
        <source>The length that you entered is %1 times the length that the cameras see: millimeters and meters are probably mixed up.</source>
        <translation>Die von Ihnen eingegebene Länge ist das %1-fache der Länge, die die Kameras sehen: wahrscheinlich sind Millimeter und Meter verwechselt.</translation>
    </message>
    <message>
        <source>The length that you entered is %1 times the length that the cameras see: you probably entered it in inches (1 inch = 2.54 cm).</source>
        <translation>Die von Ihnen eingegebene Länge ist das %1-fache der Länge, die die Kameras sehen: wahrscheinlich haben Sie sie in Zoll eingegeben (1 Zoll = 2,54 cm).</translation>
    </message>
    <message>
        <source>The corners form a board with %1 squares in a row, so the number of squares that you entered is probably wrong. Count the squares and correct the number.</source>
        <translation>Die Ecken bilden eine Tafel mit %1 Feldern in einer Reihe, also ist die von Ihnen eingegebene Zahl der Felder wahrscheinlich falsch. Zählen Sie die Felder, und berichtigen Sie die Zahl.</translation>
    </message>
    <message>
        <source>The size of the squares that you entered is %1 times the size that the cameras see. Measure a row with a ruler: prints are often rescaled.</source>
        <translation>Die von Ihnen eingegebene Größe der Felder ist das %1-fache der Größe, die die Kameras sehen. Messen Sie eine Reihe mit dem Lineal: Drucke werden oft skaliert.</translation>
    </message>
    <message>
        <source>The images fit only if they are shifted by %1 along both axes: the calibration probably counts pixel coordinates from the corner of the first pixel, not from its center. Convert the principal points.</source>
        <translation>Die Bilder passen nur, wenn sie um %1 in beiden Achsen verschoben werden: Die Kalibrierung zählt Pixelkoordinaten wahrscheinlich ab der Ecke des ersten Pixels statt ab dessen Mitte. Rechnen Sie die Hauptpunkte um.</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>±%1</source>
        <translation>±%1</translation>
    </message>
    <message>
        <source>±%1 %</source>
        <translation>±%1 %</translation>
    </message>
    <message>
        <source>not measured yet (use the page Floor)</source>
        <translation>noch nicht gemessen (auf der Seite Boden messen)</translation>
    </message>
    <message>
        <source>In the calibrated volume: position %1, scale %2, upward direction %3 (95 % of the errors are smaller).</source>
        <translation>Im kalibrierten Raum: Position %1, Maßstab %2, Richtung nach oben %3 (95 % der Fehler sind kleiner).</translation>
    </message>
    <message>
        <source>Outside the calibrated volume, up to %1 away: position ±%2 (extrapolated).</source>
        <translation>Außerhalb des kalibrierten Raums, bis %1 entfernt: Position ±%2 (extrapoliert).</translation>
    </message>
</context>
<context>
    <name>CameraAgreement</name>
    <message>
        <source>millimeters</source>
        <translation>Millimetern</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>Zentimetern</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped, or %3 and %4.</source>
        <translation>%1 und %2 sind anscheinend vertauscht, oder %3 und %4.</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped.</source>
        <translation>%1 und %2 sind anscheinend vertauscht.</translation>
    </message>
    <message>
        <source>%1 or %2 points at least %3 away from its calibrated direction.</source>
        <translation>%1 oder %2 blickt mindestens %3 an der kalibrierten Richtung vorbei.</translation>
    </message>
    <message>
        <source>%1 points about %2 away from its calibrated direction.</source>
        <translation>%1 blickt etwa %2 an der kalibrierten Richtung vorbei.</translation>
    </message>
    <message>
        <source>%1 and %2 disagree about where the target is. Calibrate them again.</source>
        <translation>%1 und %2 sehen das Ziel nicht an derselben Position. Kalibrieren Sie sie neu.</translation>
    </message>
    <message>
        <source>%1 does not agree with the other cameras. Calibrate it again.</source>
        <translation>%1 stimmt mit den anderen Kameras nicht überein. Kalibrieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The images of %1 are about %2 late.</source>
        <translation>Die Bilder von %1 sind etwa %2 zu spät.</translation>
    </message>
    <message>
        <source>The images of %1 are about %2 early.</source>
        <translation>Die Bilder von %1 sind etwa %2 zu früh.</translation>
    </message>
    <message>
        <source>The calibration seems to be in %1 instead of meters.</source>
        <translation>Die Kalibrierung ist anscheinend in %1 statt in Metern angegeben.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same pose.</source>
        <translation>%1 und %2 haben dieselbe Lage.</translation>
    </message>
    <message>
        <source>Swap %1 and %2</source>
        <translation>%1 und %2 tauschen</translation>
    </message>
    <message>
        <source>Set the delay of %1</source>
        <translation>Verzögerung von %1 einstellen</translation>
    </message>
    <message>
        <source>Correct direction of %1</source>
        <translation>Richtung von %1 korrigieren</translation>
    </message>
    <message>
        <source>Convert to meters</source>
        <translation>In Meter umrechnen</translation>
    </message>
</context>
<context>
    <name>CameraDeviceText</name>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>Automatic hue</source>
        <translation>Automatischer Farbton</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Automatic gain</source>
        <translation>Automatische Verstärkung</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Schärfe</translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation>Automatische Belichtung</translation>
    </message>
    <message>
        <source>Exposure time (× 0.1 ms)</source>
        <translation>Belichtungszeit (× 0,1 ms)</translation>
    </message>
    <message>
        <source>Lower frame rate in low light</source>
        <translation>Niedrigere Bildrate bei wenig Licht</translation>
    </message>
    <message>
        <source>Automatic white balance</source>
        <translation>Automatischer Weißabgleich</translation>
    </message>
    <message>
        <source>White balance (K)</source>
        <translation>Weißabgleich (K)</translation>
    </message>
    <message>
        <source>Backlight compensation</source>
        <translation>Gegenlichtkorrektur</translation>
    </message>
    <message>
        <source>Power line frequency</source>
        <translation>Netzfrequenz</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Automatic focus</source>
        <translation>Automatischer Fokus</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Schwenken</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigen</translation>
    </message>
    <message>
        <source>connector %1</source>
        <translation>Anschluss %1</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>Seriennummer %1</translation>
    </message>
    <message>
        <source>%1, %2 images per second</source>
        <translation>%1, %2 Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>%1 %2, %3 images per second</source>
        <translation>%1 %2, %3 Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on, manual exposure time</source>
        <translation>ein, Belichtungszeit manuell</translation>
    </message>
    <message>
        <source>on, manual aperture</source>
        <translation>ein, Blende manuell</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>white balance</source>
        <translation>Weißabgleich</translation>
    </message>
    <message>
        <source>hue</source>
        <translation>Farbton</translation>
    </message>
    <message>
        <source>USB bus %1 cannot carry the images of %2: they need %3 Mbit/s, but the bus has only %4 Mbit/s.</source>
        <translation>Der USB-Bus %1 kann die Bilder von %2 nicht übertragen: Sie brauchen %3 Mbit/s, und er hat %4 Mbit/s.</translation>
    </message>
</context>
<context>
    <name>CameraMotion</name>
    <message>
        <source>rotated by %1</source>
        <translation>um %1 gedreht</translation>
    </message>
</context>
<context>
    <name>CameraNames</name>
    <message>
        <source>camera %1</source>
        <translation>Kamera %1</translation>
    </message>
</context>
<context>
    <name>CameraView</name>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>This camera delivered no image for this frame.</source>
        <translation>Diese Kamera lieferte zu diesem Zeitpunkt kein Bild.</translation>
    </message>
    <message>
        <source>No images yet. Press play (Space), or open a project (Ctrl+O).</source>
        <translation>Noch keine Bilder. Wiedergabe starten (Leertaste) oder ein Projekt öffnen (Strg+O).</translation>
    </message>
</context>
<context>
    <name>ClickRadiusText</name>
    <message>
        <source>The target&apos;s radius seems to be about %1.</source>
        <translation>Der Radius des Ziels ist anscheinend etwa %1.</translation>
    </message>
    <message>
        <source>The marked spot is part of a larger object of the same color. Only this spot is tracked, as a ball with radius %1.</source>
        <translation>Die markierte Stelle gehört zu einem größeren Objekt derselben Farbe. Nur diese Stelle wird verfolgt, als Ball mit Radius %1.</translation>
    </message>
    <message>
        <source>The target&apos;s radius seems to be about %1, but %2 was entered. Is %2 the diameter?</source>
        <translation>Der Radius des Ziels ist anscheinend etwa %1, eingegeben wurde aber %2. Ist %2 der Durchmesser?</translation>
    </message>
    <message>
        <source>The target&apos;s radius seems to be about %1, but %2 was entered.</source>
        <translation>Der Radius des Ziels ist anscheinend etwa %1, eingegeben wurde aber %2.</translation>
    </message>
</context>
<context>
    <name>ColorLearner</name>
    <message>
        <source>target %1</source>
        <translation>Ziel %1</translation>
    </message>
</context>
<context>
    <name>ColorText</name>
    <message>
        <source>at the top left</source>
        <translation>oben links</translation>
    </message>
    <message>
        <source>at the top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>at the top right</source>
        <translation>oben rechts</translation>
    </message>
    <message>
        <source>at the left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>in the center</source>
        <translation>in der Mitte</translation>
    </message>
    <message>
        <source>at the right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>at the bottom left</source>
        <translation>unten links</translation>
    </message>
    <message>
        <source>at the bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>at the bottom right</source>
        <translation>unten rechts</translation>
    </message>
    <message>
        <source>black</source>
        <translation>Schwarzes</translation>
    </message>
    <message>
        <source>gray</source>
        <translation>Graues</translation>
    </message>
    <message>
        <source>white</source>
        <translation>Weißes</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>Braunes</translation>
    </message>
    <message>
        <source>red</source>
        <translation>Rotes</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>Oranges</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>Gelbes</translation>
    </message>
    <message>
        <source>green</source>
        <translation>Grünes</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>Türkises</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>Blaues</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>Violettes</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>Rosafarbenes</translation>
    </message>
    <message>
        <source>Much of the target does not have the learned color: Shift-click its light and its dark side.</source>
        <translation>Große Teile des Ziels haben nicht die gelernte Farbe: Umschalt-Klick auf seine helle und seine dunkle Seite.</translation>
    </message>
    <message>
        <source>Cover objects of the same color, or take them out of view.</source>
        <translation>Bedecken Sie Objekte derselben Farbe, oder nehmen Sie sie aus dem Bild.</translation>
    </message>
    <message>
        <source>The target is nearly black here: more light would help.</source>
        <translation>Das Ziel ist hier fast schwarz: Mehr Licht würde helfen.</translation>
    </message>
    <message>
        <source>The target is nearly white here: a shorter exposure would help.</source>
        <translation>Das Ziel ist hier fast weiß: Eine kürzere Belichtung würde helfen.</translation>
    </message>
    <message>
        <source>The target is nearly gray: a stronger color would help.</source>
        <translation>Das Ziel ist fast grau: Eine kräftigere Farbe würde helfen.</translation>
    </message>
    <message>
        <source>%1 % of the pixels have this color. Shift-click the target to see how well its color stands out.</source>
        <translation>%1 % der Pixel haben diese Farbe. Ein Umschalt-Klick auf das Ziel zeigt, wie gut sich seine Farbe abhebt.</translation>
    </message>
    <message>
        <source>This color also covers %1 % of the background.</source>
        <translation>Diese Farbe haben auch %1 % des Hintergrunds.</translation>
    </message>
    <message>
        <source>One sample hardly matches the learned color: the sample resembles its surroundings or shows another object.</source>
        <translation>Eine Probe passt kaum zur gelernten Farbe: Sie ähnelt ihrer Umgebung, oder sie zeigt ein anderes Objekt.</translation>
    </message>
    <message>
        <source>Several objects have this color: another color would help.</source>
        <translation>Mehrere Objekte haben diese Farbe: Eine andere Farbe würde helfen.</translation>
    </message>
    <message>
        <source>This color covers only %1 % of the target, and %2 % of the background.</source>
        <translation>Diese Farbe haben nur %1 % des Ziels und %2 % des Hintergrunds.</translation>
    </message>
    <message numerus="yes">
        <source>%n objects have this color and size: follow all of them, or cover the others.</source>
        <translation>
            <numerusform>%n Objekt hat diese Farbe und Größe: Verfolgen Sie es, oder bedecken Sie die anderen.</numerusform>
            <numerusform>%n Objekte haben diese Farbe und Größe: Verfolgen Sie alle, oder bedecken Sie die anderen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The color stands out well (%1 of 100 points).</source>
        <translation>Die Farbe hebt sich gut ab (%1 von 100 Punkten).</translation>
    </message>
    <message>
        <source>The color stands out (%1 of 100 points).</source>
        <translation>Die Farbe hebt sich ab (%1 von 100 Punkten).</translation>
    </message>
    <message>
        <source>The color is hard to tell from the background (%1 of 100 points).</source>
        <translation>Die Farbe ist schwer vom Hintergrund zu unterscheiden (%1 von 100 Punkten).</translation>
    </message>
    <message>
        <source>The color hardly stands out (%1 of 100 points).</source>
        <translation>Die Farbe hebt sich kaum ab (%1 von 100 Punkten).</translation>
    </message>
    <message>
        <source>The clicked region fills much of the image: click only the target, or drag a box around the target.</source>
        <translation>Der angeklickte Bereich füllt einen großen Teil des Bildes: Klicken Sie nur das Ziel an, oder ziehen Sie einen Rahmen um das Ziel.</translation>
    </message>
    <message>
        <source>You clicked only a speck: drag a box around the whole target.</source>
        <translation>Sie haben nur einen kleinen Fleck angeklickt: Ziehen Sie einen Rahmen um das ganze Ziel.</translation>
    </message>
    <message>
        <source>A color range that covers the whole target would also cover %1 % of the background.</source>
        <translation>Ein Farbbereich, der das ganze Ziel umfasst, würde auch %1 % des Hintergrunds umfassen.</translation>
    </message>
    <message>
        <source>Other objects have this color too: Ctrl+Shift-click them to exclude them.</source>
        <translation>Auch andere Objekte haben diese Farbe: Strg+Umschalt+Klick darauf schließt sie aus.</translation>
    </message>
    <message>
        <source>Almost nothing else in the images has this color.</source>
        <translation>Sonst hat fast nichts in den Bildern diese Farbe.</translation>
    </message>
    <message>
        <source>Only %1 % of the background has this color too, which is little compared with the target.</source>
        <translation>Nur %1 % des Hintergrunds haben auch diese Farbe; das ist wenig im Vergleich zum Ziel.</translation>
    </message>
    <message>
        <source>Outside the target, the largest region of this color (%1) is in the image of %3, %2.</source>
        <translation>Außerhalb des Ziels ist der größte Bereich dieser Farbe (%1) im Bild von %3 %2.</translation>
    </message>
</context>
<context>
    <name>Convergence</name>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Convergence in frame %1 (%2)</source>
        <comment>number of a frame, unit</comment>
        <translation>Konvergenz in Bild %1 (%2)</translation>
    </message>
    <message>
        <source>Spread of the particles after each iteration on this frame. The filter has converged where the curve levels off.</source>
        <translation>Streuung der Partikel nach jeder Iteration an diesem Bild. Wo die Kurve flach wird, ist der Filter konvergiert.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>cannot be written</source>
        <translation>kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>does not match the other data</source>
        <translation>passt nicht zu den übrigen Daten</translation>
    </message>
    <message>
        <source>ends earlier than expected</source>
        <translation>endet früher als erwartet</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>not a usable value</source>
        <translation>kein brauchbarer Wert</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>auf Wunsch abgebrochen</translation>
    </message>
    <message>
        <source>the camera cannot be opened</source>
        <translation>die Kamera lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>the camera stopped delivering images</source>
        <translation>die Kamera liefert keine Bilder mehr</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>die Datei existiert nicht</translation>
    </message>
    <message>
        <source>cannot be determined from the observations</source>
        <translation>lässt sich aus den Beobachtungen nicht bestimmen</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>this key is missing</source>
        <translation>dieser Schlüssel fehlt</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>unbekannter Schlüssel</translation>
    </message>
    <message>
        <source>wrong type of value</source>
        <translation>falsche Art von Wert</translation>
    </message>
    <message>
        <source>invalid format</source>
        <translation>ungültiges Format</translation>
    </message>
    <message>
        <source>the camera repeats images</source>
        <translation>die Kamera wiederholt Bilder</translation>
    </message>
    <message>
        <source>the camera sends fewer images than it should</source>
        <translation>die Kamera sendet weniger Bilder, als sie sollte</translation>
    </message>
    <message>
        <source>the images are black</source>
        <translation>die Bilder sind schwarz</translation>
    </message>
    <message>
        <source>the images arrive late</source>
        <translation>die Bilder kommen verspätet an</translation>
    </message>
    <message>
        <source>the images do not change</source>
        <translation>die Bilder ändern sich nicht</translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>Barrera et al. 2005, figure 3: the particles projected into both cameras while the cloud finds the ball.</source>
        <translation>Barrera et al. 2005, Abbildung 3: die Partikel in beiden Kamerabildern, während die Wolke den Ball findet.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 4: the particle cloud of figure 3 from above.</source>
        <translation>Barrera et al. 2005, Abbildung 4: die Partikelwolke aus Abbildung 3 von oben.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 6: the object jumps 2 m at iteration 30.</source>
        <translation>Barrera et al. 2005, Abbildung 6: Das Objekt springt bei Iteration 30 um 2 m.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: with one camera, the cloud moves away from the camera.</source>
        <translation>Barrera et al. 2005, Abschnitt III-B: Mit nur einer Kamera entfernt sich die Wolke von der Kamera.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 5: where a single camera finds the color, and why the cloud moves away from the camera.</source>
        <translation>Barrera et al. 2005, Abbildung 5: wo eine einzelne Kamera die Farbe findet und warum sich die Wolke von der Kamera entfernt.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009, figures 1 and 3: the regions that move in a camera&apos;s images, and the likelihood of a person at each pixel.</source>
        <translation>Mohedano et al. 2009, Abbildungen 1 und 3: die Bereiche, die sich in den Bildern einer Kamera bewegen, und die Likelihood einer Person an jedem Pixel.</translation>
    </message>
    <message>
        <source>Drift of the estimate along the optical axis</source>
        <translation>Abdrift der Schätzung entlang der optischen Achse</translation>
    </message>
    <message>
        <source>Error after a jump of the object</source>
        <translation>Fehler nach einem Sprung des Objekts</translation>
    </message>
    <message>
        <source>Particles from above</source>
        <translation>Partikel von oben</translation>
    </message>
    <message>
        <source>Particles in both camera images</source>
        <translation>Partikel in beiden Kamerabildern</translation>
    </message>
    <message>
        <source>The particle cloud over time</source>
        <translation>Die Partikelwolke im Verlauf</translation>
    </message>
    <message>
        <source>Motion masks and motion likelihood</source>
        <translation>Bewegungsmasken und Bewegungswahrscheinlichkeit</translation>
    </message>
    <message>
        <source>Box tracking: error, success and precision</source>
        <translation>Verfolgung von Rahmen: Fehler, Erfolg und Genauigkeit</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet, stop and walk back.</source>
        <translation>Mohedano u. a. 2009: Zwei Personen treffen sich, bleiben stehen und gehen zurück.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people walk close to each other.</source>
        <translation>Mohedano u. a. 2009: Zwei Personen gehen dicht nebeneinander.</translation>
    </message>
    <message>
        <source>People side by side</source>
        <translation>Personen nebeneinander</translation>
    </message>
    <message>
        <source>People whose paths cross</source>
        <translation>Personen, deren Wege sich kreuzen</translation>
    </message>
    <message>
        <source>People who enter and leave</source>
        <translation>Personen, die kommen und gehen</translation>
    </message>
    <message>
        <source>People who meet and turn back</source>
        <translation>Personen, die sich treffen und umkehren</translation>
    </message>
    <message>
        <source>People who stay apart</source>
        <translation>Personen, die Abstand halten</translation>
    </message>
    <message>
        <source>Barrera et al. 2005: a ball in space</source>
        <translation>Barrera et al. 2005: ein Ball im Raum</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009: boxes in the images of one camera</source>
        <translation>Sugandi u. a. 2009: Rahmen in den Bildern einer Kamera</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people</source>
        <translation>Mohedano u. a. 2009: Personen</translation>
    </message>
    <message>
        <source>More scenes of people</source>
        <translation>Weitere Szenen mit Personen</translation>
    </message>
    <message>
        <source>People of different heights</source>
        <translation>Verschieden große Personen</translation>
    </message>
    <message>
        <source>People who sit and crouch</source>
        <translation>Personen, die sitzen und hocken</translation>
    </message>
    <message>
        <source>One person sits down on a stool and rises, one crouches and rises, and one walks by.</source>
        <translation>Eine Person setzt sich auf einen Hocker und steht auf, eine hockt sich hin und steht auf, und eine geht vorbei.</translation>
    </message>
    <message>
        <source>People who carry objects</source>
        <translation>Personen, die etwas tragen</translation>
    </message>
    <message>
        <source>Two people walk past each other, one with a box in front of the chest, one with a bag.</source>
        <translation>Zwei Personen gehen aneinander vorbei, eine mit einer Kiste vor der Brust, eine mit einer Tasche.</translation>
    </message>
    <message>
        <source>A crowd</source>
        <translation>Ein Gedränge</translation>
    </message>
    <message>
        <source>Five to eight people walk about for 12 s; their paths may touch and cross.</source>
        <translation>Fünf bis acht Personen laufen 12 s lang durcheinander; ihre Wege können sich berühren und kreuzen.</translation>
    </message>
    <message>
        <source>People seen by two cameras</source>
        <translation>Personen, die zwei Kameras sehen</translation>
    </message>
    <message>
        <source>Two people walk past each other, seen by only two of the four cameras.</source>
        <translation>Zwei Personen gehen aneinander vorbei; nur zwei der vier Kameras sehen sie.</translation>
    </message>
    <message>
        <source>Two people come within 0.15 to 0.28 m of each other, stand there, and go back.</source>
        <translation>Zwei Personen nähern sich auf 0,15 bis 0,28 m, bleiben stehen und gehen zurück.</translation>
    </message>
    <message>
        <source>Furniture that moves</source>
        <translation>Möbel, die sich bewegen</translation>
    </message>
    <message>
        <source>A cabinet and a stool are moved after the cameras have learned the background.</source>
        <translation>Ein Schrank und ein Hocker werden verschoben, nachdem die Kameras den Hintergrund gelernt haben.</translation>
    </message>
    <message>
        <source>Clothes in the room&apos;s colors</source>
        <translation>Kleidung in den Farben des Raums</translation>
    </message>
    <message>
        <source>Two people whose clothes have the colors of walls, furniture and floor walk past each other.</source>
        <translation>Zwei Personen in Kleidung in den Farben von Wänden, Möbeln und Boden gehen aneinander vorbei.</translation>
    </message>
    <message>
        <source>Patterned clothes</source>
        <translation>Gemusterte Kleidung</translation>
    </message>
    <message>
        <source>Two people in striped, checked or blotched shirts walk past each other.</source>
        <translation>Zwei Personen in gestreiften, karierten oder gefleckten Hemden gehen aneinander vorbei.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 7: the error after the jump of figure 6, for motion sigmas from 0.001 to 0.3 m, drawn as an image.</source>
        <translation>Barrera et al. 2005, Abbildung 7: der Fehler nach dem Sprung aus Abbildung 6 für Bewegungs-Sigmas von 0,001 bis 0,3 m, als Bild gezeichnet.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 8: the cloud in six iterations, with a small and with a large motion sigma.</source>
        <translation>Barrera et al. 2005, Abbildung 8: die Wolke in sechs Iterationen, mit kleinem und mit großem Bewegungs-Sigma.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: the share of runs that converge, for start volumes of different sizes, and for start points at different distances behind the ball.</source>
        <translation>Barrera et al. 2005, Abschnitt III-B: der Anteil der Läufe, die konvergieren, für verschieden große Startvolumen und für Startpunkte in verschiedenen Abständen hinter dem Ball.</translation>
    </message>
    <message>
        <source>Error after each iteration, for different motion sigmas</source>
        <translation>Fehler nach jeder Iteration, für verschiedene Bewegungs-Sigmas</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people enter and leave. Measures how long an estimate exists where nobody is, and how long a person has no estimate.</source>
        <translation>Mohedano u. a. 2009: Personen kommen und gehen. Misst, wie lange es eine Schätzung gibt, wo niemand ist, und wie lange eine Person keine Schätzung hat.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people far apart. This is the easy case: no method should mix them up.</source>
        <translation>Mohedano u. a. 2009: zwei Personen, weit voneinander entfernt. Das ist der leichte Fall: Kein Verfahren sollte sie verwechseln.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet and walk on. A method that uses only motion may mix them up; color tells them apart if their clothes differ.</source>
        <translation>Mohedano u. a. 2009: Zwei Personen begegnen sich und gehen weiter. Ein Verfahren, das nur die Bewegung nutzt, kann sie verwechseln; die Farbe hält sie auseinander, wenn ihre Kleidung verschieden ist.</translation>
    </message>
    <message>
        <source>People who come close to each other</source>
        <translation>Menschen, die einander nahe kommen</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009, section 4: compares method sugandi with 100 and with 300 particles, method histogram, and four trackers of OpenCV, all on the same clips.</source>
        <translation>Sugandi u. a. 2009, Abschnitt 4: vergleicht das Verfahren sugandi mit 100 und mit 300 Partikeln, das Verfahren histogram und vier Verfolger von OpenCV, alle auf denselben Filmen.</translation>
    </message>
    <message>
        <source>Three people walk about: a child 0.9 to 1.3 m tall, a person 1.3 to 1.6 m tall and a person 1.88 to 2 m tall.</source>
        <translation>Drei Personen gehen umher: ein Kind von 0,9 bis 1,3 m Größe, eine Person von 1,3 bis 1,6 m und eine von 1,88 bis 2 m Größe.</translation>
    </message>
    <message>
        <source>Where a single camera finds the color</source>
        <translation>Wo eine einzelne Kamera die Farbe findet</translation>
    </message>
    <message>
        <source>From which starting positions the particles still find the target</source>
        <translation>Von welchen Startpositionen aus die Partikel das Ziel noch finden</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>CSV, one row per target and time</source>
        <translation>CSV, eine Zeile je Ziel und Zeitpunkt</translation>
    </message>
    <message>
        <source>CSV, one row per time (spreadsheets)</source>
        <translation>CSV, eine Zeile je Zeitpunkt (Tabellen)</translation>
    </message>
    <message>
        <source>TUM (evo)</source>
        <translation>TUM (evo)</translation>
    </message>
    <message>
        <source>TRC (OpenSim)</source>
        <translation>TRC (OpenSim)</translation>
    </message>
    <message>
        <source>C3D (motion capture)</source>
        <translation>C3D (Bewegungserfassung)</translation>
    </message>
    <message>
        <source>NPZ (NumPy)</source>
        <translation>NPZ (NumPy)</translation>
    </message>
    <message>
        <source>VTP (ParaView, paths)</source>
        <translation>VTP (ParaView, Bahnen)</translation>
    </message>
    <message>
        <source>PVD (ParaView, over time)</source>
        <translation>PVD (ParaView, über die Zeit)</translation>
    </message>
    <message>
        <source>JSON lines</source>
        <translation>JSON-Zeilen</translation>
    </message>
    <message>
        <source>Z points up, axes as in the project</source>
        <translation>Z zeigt nach oben, Achsen wie im Projekt</translation>
    </message>
    <message>
        <source>Lengths in %1, times in s, covariances in %1². %2.</source>
        <translation>Längen in %1, Zeiten in s, Kovarianzen in %1². %2.</translation>
    </message>
    <message>
        <source>no gaps</source>
        <translation>keine Lücken</translation>
    </message>
    <message>
        <source>%1 positions unknown</source>
        <translation>%1 Positionen unbekannt</translation>
    </message>
    <message>
        <source>Targets: %1, rows: %2 at %3 per second, %4.</source>
        <translation>Ziele: %1, Zeilen: %2 bei %3 pro Sekunde, %4.</translation>
    </message>
    <message>
        <source>Y points up: x, y, z of the file are y, z, x of the project</source>
        <translation>Y zeigt nach oben: x, y, z der Datei sind y, z, x des Projekts</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Wrote the figure %1.</source>
        <translation>Die Abbildung %1 wurde geschrieben.</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2 files; the last is %3.</source>
        <translation>%1 Zeilen in %2 Dateien exportiert; die letzte ist %3.</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2.</source>
        <translation>%1 Zeilen nach %2 exportiert.</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>%1 and %2 have the same pose.</source>
        <translation>%1 und %2 haben dieselbe Lage.</translation>
    </message>
    <message>
        <source>%1 has %2 frames of %3 pixels, %4.</source>
        <translation>%1 hat %2 Bilder mit %3 Pixeln, %4.</translation>
    </message>
    <message>
        <source>%1 is %2 m below the floor (z = 0).</source>
        <translation>%1 liegt %2 m unter dem Boden (z = 0).</translation>
    </message>
    <message>
        <source>The view of %1 does not overlap with the view of any other camera.</source>
        <translation>Das Blickfeld von %1 überschneidet sich mit dem keiner anderen Kamera.</translation>
    </message>
    <message>
        <source>A file of the project is missing: %1.</source>
        <translation>Eine Datei des Projekts fehlt: %1.</translation>
    </message>
    <message>
        <source>According to their tables of times, the cameras never recorded at the same time.</source>
        <translation>Nach ihren Zeittabellen haben die Kameras nie gleichzeitig aufgenommen.</translation>
    </message>
    <message>
        <source>Add a target, or choose a method that finds targets by itself.</source>
        <translation>Fügen Sie ein Ziel hinzu, oder wählen Sie ein Verfahren, das Ziele selbst findet.</translation>
    </message>
    <message>
        <source>Add cameras, or choose another method.</source>
        <translation>Fügen Sie Kameras hinzu, oder wählen Sie ein anderes Verfahren.</translation>
    </message>
    <message>
        <source>Calibrate both cameras again; the pose of one was probably copied from the other.</source>
        <translation>Kalibrieren Sie beide Kameras neu; wahrscheinlich wurde die Lage der einen von der anderen kopiert.</translation>
    </message>
    <message>
        <source>Calibrate the cameras with a board, a wand or measured points.</source>
        <translation>Kalibrieren Sie die Kameras mit einer Tafel, einem Stab oder gemessenen Punkten.</translation>
    </message>
    <message>
        <source>Calibrate the cameras, or choose a method that tracks boxes in images.</source>
        <translation>Kalibrieren Sie die Kameras, oder wählen Sie ein Verfahren, das Rahmen in Bildern verfolgt.</translation>
    </message>
    <message>
        <source>In the project file, check the value of late_by for this camera. It is in seconds.</source>
        <translation>Prüfen Sie in der Projektdatei den Wert von late_by für diese Kamera. Er ist in Sekunden angegeben.</translation>
    </message>
    <message>
        <source>Check that the camera sees the target, and check its exposure and white balance.</source>
        <translation>Prüfen Sie, ob die Kamera das Ziel sieht, und prüfen Sie Belichtung und Weißabgleich.</translation>
    </message>
    <message>
        <source>Check that the time stamps of all cameras (in their tables of times) are from the same clock.</source>
        <translation>Prüfen Sie, ob die Zeitstempel aller Kameras (in ihren Zeittabellen) von derselben Uhr stammen.</translation>
    </message>
    <message>
        <source>Check that the corrections were made for this recording.</source>
        <translation>Prüfen Sie, ob die Korrekturen für diese Aufnahme gemacht wurden.</translation>
    </message>
    <message>
        <source>Check that z points up and is 0 on the floor, unless you placed the origin elsewhere.</source>
        <translation>Prüfen Sie, ob z nach oben zeigt und am Boden 0 ist, sofern Sie den Ursprung nicht woandershin gelegt haben.</translation>
    </message>
    <message>
        <source>Click the target in an image, or use the command learn-color.</source>
        <translation>Klicken Sie das Ziel in einem Bild an, oder verwenden Sie den Befehl learn-color.</translation>
    </message>
    <message>
        <source>Convert the recordings to the same frame rate, or give each camera a table of times.</source>
        <translation>Bringen Sie die Aufnahmen auf dieselbe Bildrate, oder geben Sie für jede Kamera eine Zeittabelle an.</translation>
    </message>
    <message>
        <source>Copy the recording again, or convert it with FFmpeg.</source>
        <translation>Kopieren Sie die Aufnahme noch einmal, oder wandeln Sie sie mit FFmpeg um.</translation>
    </message>
    <message>
        <source>Copy the video again, or repair it with FFmpeg (ffmpeg -i IN -c copy OUT).</source>
        <translation>Kopieren Sie das Video noch einmal, oder reparieren Sie es mit FFmpeg (ffmpeg -i EINGABE -c copy AUSGABE).</translation>
    </message>
    <message>
        <source>Copy the image folder again; otherwise the camera has no image in the missing frames.</source>
        <translation>Kopieren Sie den Bilderordner noch einmal; sonst hat die Kamera an den fehlenden Stellen kein Bild.</translation>
    </message>
    <message>
        <source>Copy the recording again, or use only the frames before the unreadable one.</source>
        <translation>Kopieren Sie die Aufnahme noch einmal, oder verwenden Sie nur die Bilder vor dem unlesbaren.</translation>
    </message>
    <message>
        <source>In the project file, correct the value of late_by for this camera. It is in seconds.</source>
        <translation>Korrigieren Sie in der Projektdatei den Wert von late_by für diese Kamera. Er ist in Sekunden angegeben.</translation>
    </message>
    <message>
        <source>Correct the file of true positions, or remove the key &apos;truth&apos; from the project file.</source>
        <translation>Korrigieren Sie die Datei der wahren Positionen, oder entfernen Sie den Schlüssel „truth“ aus der Projektdatei.</translation>
    </message>
    <message>
        <source>Correct the project file in a text editor, or make a new project.</source>
        <translation>Korrigieren Sie die Projektdatei in einem Texteditor, oder erstellen Sie ein neues Projekt.</translation>
    </message>
    <message>
        <source>Correct the table of times, or remove this camera&apos;s key &apos;times&apos; from the project file.</source>
        <translation>Korrigieren Sie die Zeittabelle, oder entfernen Sie den Schlüssel „times“ dieser Kamera aus der Projektdatei.</translation>
    </message>
    <message>
        <source>The project has corrections for frames that the recording does not have: %1.</source>
        <translation>Das Projekt hat Korrekturen für Bilder, die es in der Aufnahme nicht gibt: %1.</translation>
    </message>
    <message>
        <source>Draw the box in an earlier frame.</source>
        <translation>Ziehen Sie den Rahmen in einem früheren Bild.</translation>
    </message>
    <message>
        <source>Draw a box around the target in an image.</source>
        <translation>Ziehen Sie in einem Bild einen Rahmen um das Ziel.</translation>
    </message>
    <message>
        <source>Frame %2 of %1 cannot be read: %3.</source>
        <translation>Bild %2 von %1 kann nicht gelesen werden: %3.</translation>
    </message>
    <message>
        <source>Give a table of times to every camera, or to none.</source>
        <translation>Geben Sie für alle Kameras eine Zeittabelle an oder für keine.</translation>
    </message>
    <message>
        <source>Give the radius in meters.</source>
        <translation>Geben Sie den Radius in Metern an.</translation>
    </message>
    <message>
        <source>Import the calibration again, or calibrate the cameras again.</source>
        <translation>Importieren Sie die Kalibrierung noch einmal, oder kalibrieren Sie die Kameras neu.</translation>
    </message>
    <message>
        <source>Import the calibration again with the right unit (calibration convert --unit).</source>
        <translation>Importieren Sie die Kalibrierung noch einmal mit der richtigen Einheit (calibration convert --unit).</translation>
    </message>
    <message>
        <source>In the first %1 s, the images do not fit the calibration: %2.</source>
        <translation>In den ersten %1 s passen die Bilder nicht zur Kalibrierung: %2.</translation>
    </message>
    <message>
        <source>Judging by the numbers in the file names, %2 of %3 images of %1 are missing, the first one after %4.</source>
        <translation>Nach den Nummern in den Dateinamen fehlen Bilder von %1 (%2 von %3), das erste nach %4.</translation>
    </message>
    <message>
        <source>Learn the color again in an image of this recording.</source>
        <translation>Lernen Sie die Farbe in einem Bild dieser Aufnahme neu.</translation>
    </message>
    <message>
        <source>Learn the color again, with samples that do not reach beyond the target.</source>
        <translation>Lernen Sie die Farbe neu, mit Proben, die nicht über das Ziel hinausreichen.</translation>
    </message>
    <message>
        <source>Learn the color again.</source>
        <translation>Lernen Sie die Farbe neu.</translation>
    </message>
    <message>
        <source>Make one project of the live cameras and another one of the recordings.</source>
        <translation>Erstellen Sie ein Projekt mit den Livekameras und ein zweites mit den Aufnahmen.</translation>
    </message>
    <message>
        <source>Free some disk space, or write to another disk with the option --out.</source>
        <translation>Schaffen Sie Platz, oder schreiben Sie mit der Option --out auf ein anderes Laufwerk.</translation>
    </message>
    <message>
        <source>Move the volume of interest, or remove it.</source>
        <translation>Verschieben Sie den Suchraum, oder entfernen Sie ihn.</translation>
    </message>
    <message>
        <source>No part of the volume of interest is seen by enough cameras (at least %1 are needed).</source>
        <translation>Kein Teil des Suchraums ist in genügend Kameras zu sehen (mindestens %1 sind nötig).</translation>
    </message>
    <message>
        <source>No pixel can have the color of target %1: the color range is too narrow.</source>
        <translation>Kein Pixel kann die Farbe von Ziel %1 haben: Der Farbbereich ist zu eng.</translation>
    </message>
    <message>
        <source>Nothing can be tracked: %1.</source>
        <translation>Es kann nichts verfolgt werden: %1.</translation>
    </message>
    <message>
        <source>Nothing can be written to the folder of the project.</source>
        <translation>In den Ordner des Projekts kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Only %1 GB are free for results.</source>
        <translation>Für Ergebnisse sind nur %1 GB frei.</translation>
    </message>
    <message>
        <source>Only %1 MB are free for results.</source>
        <translation>Für Ergebnisse sind nur %1 MB frei.</translation>
    </message>
    <message>
        <source>Only the first %2 frames of each recording are used; check that all recordings begin at the same time.</source>
        <translation>Von jeder Aufnahme werden nur die ersten %2 Bilder verwendet; prüfen Sie, ob alle Aufnahmen gleichzeitig beginnen.</translation>
    </message>
    <message>
        <source>Open the project to see whether images arrive.</source>
        <translation>Öffnen Sie das Projekt, um zu sehen, ob Bilder ankommen.</translation>
    </message>
    <message>
        <source>Other cameras have a table of times, but %1 has none.</source>
        <translation>Andere Kameras haben eine Zeittabelle, %1 hat keine.</translation>
    </message>
    <message>
        <source>Connect the device, or choose another one.</source>
        <translation>Schließen Sie das Gerät an, oder wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>Put the missing file or folder back, or correct its path in the project file.</source>
        <translation>Bringen Sie die fehlende Datei oder den Ordner an den alten Ort zurück, oder korrigieren Sie den Pfad in der Projektdatei.</translation>
    </message>
    <message>
        <source>Remove frames_per_second from the project file, unless the rate stated in the video is wrong.</source>
        <translation>Entfernen Sie frames_per_second aus der Projektdatei, sofern die Angabe im Video nicht falsch ist.</translation>
    </message>
    <message>
        <source>Set frames_per_second in the project file; the measured speeds depend on it.</source>
        <translation>Setzen Sie frames_per_second in der Projektdatei; die gemessenen Geschwindigkeiten hängen davon ab.</translation>
    </message>
    <message>
        <source>In the project file, set the key &apos;rotate&apos; of this camera to 90 or 270.</source>
        <translation>Setzen Sie in der Projektdatei den Schlüssel „rotate“ dieser Kamera auf 90 oder 270.</translation>
    </message>
    <message>
        <source>Simulated cameras: %1.</source>
        <translation>Simulierte Kameras: %1.</translation>
    </message>
    <message>
        <source>Solve this problem, then check again.</source>
        <translation>Beheben Sie das genannte Problem, und prüfen Sie dann erneut.</translation>
    </message>
    <message>
        <source>Some cameras are live and others are recordings.</source>
        <translation>Einige Kameras sind live, andere sind Aufnahmen.</translation>
    </message>
    <message>
        <source>Take the background image again, or remove this camera&apos;s key &apos;empty_room&apos; from the project file.</source>
        <translation>Nehmen Sie das Hintergrundbild neu auf, oder entfernen Sie den Schlüssel „empty_room“ dieser Kamera aus der Projektdatei.</translation>
    </message>
    <message>
        <source>Target %1 has a radius of %2 m, which is larger than a person.</source>
        <translation>Ziel %1 hat einen Radius von %2 m und wäre damit größer als ein Mensch.</translation>
    </message>
    <message>
        <source>Target %1 has no box to start from.</source>
        <translation>Ziel %1 hat keinen Rahmen, mit dem die Verfolgung beginnen könnte.</translation>
    </message>
    <message>
        <source>Target %1 has no color yet.</source>
        <translation>Ziel %1 hat noch keine Farbe.</translation>
    </message>
    <message>
        <source>The background image of %1 cannot be used: %2.</source>
        <translation>Das Hintergrundbild von %1 ist nicht verwendbar: %2.</translation>
    </message>
    <message>
        <source>The box of target %1 is in frame %2, but the last frame is frame %3.</source>
        <translation>Der Rahmen von Ziel %1 gehört zu Bild %2, das letzte Bild ist aber Bild %3.</translation>
    </message>
    <message>
        <source>The calibration cannot be right: %1.</source>
        <translation>Die Kalibrierung kann nicht stimmen: %1.</translation>
    </message>
    <message>
        <source>The calibration is plausible (cameras: %1, largest distance between them: %2 m).</source>
        <translation>Die Kalibrierung ist plausibel (Kameras: %1, größter Abstand: %2 m).</translation>
    </message>
    <message>
        <source>The cameras are %1 m apart: their positions are probably in units of %2 m.</source>
        <translation>Die Kameras sind %1 m voneinander entfernt: Ihre Positionen sind wahrscheinlich in Einheiten von %2 m angegeben.</translation>
    </message>
    <message>
        <source>The cameras are not calibrated: their poses are guesses, so tracked positions mean nothing.</source>
        <translation>Die Kameras sind nicht kalibriert: Ihre Lagen sind nur angenommen, verfolgte Positionen haben deshalb keine Bedeutung.</translation>
    </message>
    <message>
        <source>In the images of %3, %2 % of all pixels have the color of target %1.</source>
        <translation>In den Bildern von %3 haben %2 % aller Pixel die Farbe von Ziel %1.</translation>
    </message>
    <message>
        <source>In the images, %2 % of all pixels have the color of target %1.</source>
        <translation>In den Bildern haben %2 % aller Pixel die Farbe von Ziel %1.</translation>
    </message>
    <message>
        <source>The color of target %1 was not found in any of the %2 checked images.</source>
        <translation>Die Farbe von Ziel %1 war in keinem der %2 geprüften Bilder zu finden.</translation>
    </message>
    <message>
        <source>The color of target %1 was not found in any of the checked images of %2.</source>
        <translation>Die Farbe von Ziel %1 war in keinem der geprüften Bilder von %2 zu finden.</translation>
    </message>
    <message>
        <source>The delay of %1 is %2 s, which is unusually large.</source>
        <translation>Die Verzögerung von %1 beträgt %2 s, das ist ungewöhnlich viel.</translation>
    </message>
    <message>
        <source>The delay of %1 (%2 s) is longer than its recording, so this camera has no image in any frame.</source>
        <translation>Die Verzögerung von %1 (%2 s) ist länger als ihre Aufnahme; deshalb hat diese Kamera zu keinem Zeitpunkt ein Bild.</translation>
    </message>
    <message>
        <source>The device of %1 is connected.</source>
        <translation>Das Gerät von %1 ist angeschlossen.</translation>
    </message>
    <message>
        <source>The device of %1 is not connected: %2.</source>
        <translation>Das Gerät von %1 ist nicht angeschlossen: %2.</translation>
    </message>
    <message>
        <source>The frame rate of the images is not given; %1 frames per second are assumed.</source>
        <translation>Die Bildrate der Bilder ist nirgends angegeben; angenommen werden %1 Bilder je Sekunde.</translation>
    </message>
    <message>
        <source>The images of %1 have %2 pixels, but its calibration is for %3.</source>
        <translation>Die Bilder von %1 haben %2 Pixel, die Kalibrierung gilt aber für %3.</translation>
    </message>
    <message>
        <source>The method %1 can work with this project.</source>
        <translation>Das Verfahren %1 kann mit diesem Projekt arbeiten.</translation>
    </message>
    <message>
        <source>The method %1 needs at least %2 cameras; this project has %3.</source>
        <translation>Das Verfahren %1 braucht mindestens %2 Kameras; vorhanden: %3.</translation>
    </message>
    <message>
        <source>The method %1 needs calibrated cameras.</source>
        <translation>Das Verfahren %1 braucht kalibrierte Kameras.</translation>
    </message>
    <message>
        <source>The project can be read.</source>
        <translation>Das Projekt ist lesbar.</translation>
    </message>
    <message>
        <source>The project cannot be opened: %1.</source>
        <translation>Das Projekt lässt sich nicht öffnen: %1.</translation>
    </message>
    <message>
        <source>The project cannot be read: %1.</source>
        <translation>Das Projekt kann nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>The project says %1 frames per second, but the video of %2 has %3.</source>
        <translation>Das Projekt nennt %1 Bilder je Sekunde, das Video von %2 hat aber %3.</translation>
    </message>
    <message>
        <source>The recording of %1 cannot be opened: %2.</source>
        <translation>Die Aufnahme von %1 lässt sich nicht öffnen: %2.</translation>
    </message>
    <message>
        <source>The recording of %1 is missing: %2.</source>
        <translation>Die Aufnahme von %1 fehlt: %2.</translation>
    </message>
    <message>
        <source>The recordings differ in length: %1.</source>
        <translation>Die Aufnahmen sind verschieden lang: %1.</translation>
    </message>
    <message>
        <source>The recordings have different frame rates: %1.</source>
        <translation>Die Aufnahmen haben verschiedene Bildraten: %1.</translation>
    </message>
    <message>
        <source>The stream of %1 was not tested: the check opens no network connections.</source>
        <translation>Der Strom von %1 wurde nicht getestet: Die Prüfung öffnet keine Netzwerkverbindung.</translation>
    </message>
    <message>
        <source>The table of times of %1 cannot be used: %2.</source>
        <translation>Die Zeittabelle von %1 ist nicht verwendbar: %2.</translation>
    </message>
    <message>
        <source>The table of times of %1 has %2 times, but there are %3 images.</source>
        <translation>Die Zeittabelle von %1 hat %2 Zeiten, es gibt aber %3 Bilder.</translation>
    </message>
    <message>
        <source>The true positions cannot be read: %1.</source>
        <translation>Die wahren Positionen können nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>The video of %1 is cut off: %2.</source>
        <translation>Das Video von %1 ist abgeschnitten: %2.</translation>
    </message>
    <message>
        <source>There is enough disk space for results: %1 GB are free.</source>
        <translation>Für Ergebnisse ist genug Speicherplatz da: %1 GB sind frei.</translation>
    </message>
    <message>
        <source>Turn this camera toward the target, or calibrate it again.</source>
        <translation>Drehen Sie diese Kamera zum Ziel, oder kalibrieren Sie sie neu.</translation>
    </message>
    <message>
        <source>Use a calibration for images of this size, or record images of the calibrated size.</source>
        <translation>Verwenden Sie eine Kalibrierung für Bilder dieser Größe, oder nehmen Sie Bilder der kalibrierten Größe auf.</translation>
    </message>
    <message>
        <source>Use the table of times that belongs to this recording.</source>
        <translation>Verwenden Sie die Zeittabelle, die zu dieser Aufnahme gehört.</translation>
    </message>
    <message>
        <source>Write the results to another folder with the option --out.</source>
        <translation>Schreiben Sie die Ergebnisse mit der Option --out in einen anderen Ordner.</translation>
    </message>
    <message>
        <source>When the color of target %1 was learned, %2 % of its pixels in %3 were overexposed.</source>
        <translation>Als die Farbe von Ziel %1 gelernt wurde, waren %2 % seiner Pixel in %3 überbelichtet.</translation>
    </message>
    <message>
        <source>When the color of target %1 was learned, %2 % of its pixels in %3 were too dark.</source>
        <translation>Als die Farbe von Ziel %1 gelernt wurde, waren %2 % seiner Pixel in %3 zu dunkel.</translation>
    </message>
    <message>
        <source>Lower the exposure of the camera, and learn the color again in new images.</source>
        <translation>Verringern Sie die Belichtung der Kamera, und lernen Sie die Farbe in neuen Bildern erneut.</translation>
    </message>
    <message>
        <source>Raise the exposure of the camera or add light, and learn the color again in new images.</source>
        <translation>Erhöhen Sie die Belichtung der Kamera oder sorgen Sie für mehr Licht, und lernen Sie die Farbe in neuen Bildern erneut.</translation>
    </message>
</context>
<context>
    <name>FindingText</name>
    <message>
        <source>camera “%1”</source>
        <translation>Kamera „%1“</translation>
    </message>
</context>
<context>
    <name>GlContext</name>
    <message>
        <source>no OpenGL context can be made on this display</source>
        <translation>auf dieser Anzeige lässt sich kein OpenGL-Kontext anlegen</translation>
    </message>
    <message>
        <source>the OpenGL context cannot be used</source>
        <translation>der OpenGL-Kontext ist nicht benutzbar</translation>
    </message>
    <message>
        <source>OpenGL 3.2 is needed</source>
        <translation>OpenGL 3.2 wird benötigt</translation>
    </message>
</context>
<context>
    <name>GuideText</name>
    <message>
        <source>guessed</source>
        <translation>geraten</translation>
    </message>
    <message>
        <source>exact (simulated)</source>
        <translation>exakt (simuliert)</translation>
    </message>
    <message>
        <source>set by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>measured points</source>
        <translation>gemessene Punkte</translation>
    </message>
    <message>
        <source>board</source>
        <translation>Kalibriertafel</translation>
    </message>
    <message>
        <source>wand</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>aus einer Datei</translation>
    </message>
    <message>
        <source>points marked in the images</source>
        <translation>in den Bildern markierte Punkte</translation>
    </message>
    <message>
        <source>%1, ±%2</source>
        <translation>%1, ±%2</translation>
    </message>
    <message>
        <source>By hand: fit a drawn grid to the images</source>
        <translation>Von Hand: ein gezeichnetes Gitter auf die Bilder legen</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Gemessene Punkte</translation>
    </message>
    <message>
        <source>Printed board</source>
        <translation>Gedruckte Kalibriertafel</translation>
    </message>
    <message>
        <source>Wand: a ball, or a stick with two balls</source>
        <translation>Stab: ein Ball oder ein Stab mit zwei Bällen</translation>
    </message>
    <message>
        <source>File of another program</source>
        <translation>Datei eines anderen Programms</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Import the file</source>
        <translation>Datei importieren</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Kalibrierung importieren…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Print a board</source>
        <translation>Kalibriertafel drucken</translation>
    </message>
    <message>
        <source>Go to the page Board</source>
        <translation>Zur Seite Tafel</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>Objektive</translation>
    </message>
    <message>
        <source>Calibrate the lenses</source>
        <translation>Objektive kalibrieren</translation>
    </message>
    <message>
        <source>Set the field of view</source>
        <translation>Bildwinkel einstellen</translation>
    </message>
    <message>
        <source>Go to the page By hand</source>
        <translation>Zur Seite Von Hand</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Lay the grid over the room</source>
        <translation>Gitter über den Raum legen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Measure points and click them</source>
        <translation>Punkte messen und anklicken</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positionen</translation>
    </message>
    <message>
        <source>Compute the cameras</source>
        <translation>Kameras berechnen</translation>
    </message>
    <message>
        <source>Find the camera positions</source>
        <translation>Kamerapositionen finden</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Grob</translation>
    </message>
    <message>
        <source>Place the cameras roughly</source>
        <translation>Kameras ungefähr platzieren</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Ball</translation>
    </message>
    <message>
        <source>Learn the color of the ball</source>
        <translation>Farbe des Balls lernen</translation>
    </message>
    <message>
        <source>Click the ball in an image. For a stick with two balls, learn two targets of different colors.</source>
        <translation>Klicken Sie den Ball in einem Bild an. Für einen Stab mit zwei Bällen lernen Sie zwei Ziele mit verschiedenen Farben.</translation>
    </message>
    <message>
        <source>Learn color</source>
        <translation>Farbe lernen</translation>
    </message>
    <message>
        <source>Wave</source>
        <translation>Schwenken</translation>
    </message>
    <message>
        <source>Wave the wand</source>
        <translation>Stab schwenken</translation>
    </message>
    <message>
        <source>Go to the page Wand</source>
        <translation>Zur Seite Stab</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Set floor and origin</source>
        <translation>Boden und Ursprung setzen</translation>
    </message>
    <message>
        <source>Go to the page Floor</source>
        <translation>Zur Seite Boden</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Check a measured length</source>
        <translation>Gemessene Länge prüfen</translation>
    </message>
    <message>
        <source>Not done yet.</source>
        <translation>Noch nicht erledigt.</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Erledigt.</translation>
    </message>
    <message>
        <source>the z axis does not seem to point up</source>
        <translation>die z-Achse zeigt anscheinend nicht nach oben</translation>
    </message>
    <message>
        <source>%1, ±%2: too inaccurate</source>
        <translation>%1, ±%2: zu ungenau</translation>
    </message>
    <message>
        <source>You need one known length, such as the length of a table or of a floor tile. You get a first result within minutes.</source>
        <translation>Sie brauchen eine bekannte Länge, zum Beispiel die eines Tischs oder einer Bodenfliese. In wenigen Minuten haben Sie ein erstes Ergebnis.</translation>
    </message>
    <message>
        <source>You need a printed board that you can carry through the room. This is the most accurate way to calibrate the lenses.</source>
        <translation>Sie brauchen eine gedruckte Kalibriertafel, die Sie durch den Raum tragen können. So werden die Objektive am genauesten kalibriert.</translation>
    </message>
    <message>
        <source>You need rough camera positions and a ball to wave. This is the most accurate way to find the camera positions in a large room.</source>
        <translation>Sie brauchen ungefähre Kamerapositionen und einen Ball zum Schwenken. So lassen sich die Kamerapositionen in einem großen Raum am genauesten bestimmen.</translation>
    </message>
    <message>
        <source>You need a calibration file for these cameras and for images of this size.</source>
        <translation>Sie brauchen eine Kalibrierungsdatei für diese Kameras und für Bilder dieser Größe.</translation>
    </message>
    <message>
        <source>Choose the file. If something is missing in the file, such as the unit, the dialog asks you for it. The dialog also shows how far each camera would move.</source>
        <translation>Wählen Sie die Datei. Fehlt etwas in der Datei, zum Beispiel die Einheit, fragt der Dialog Sie danach. Der Dialog zeigt auch, wie weit sich jede Kamera bewegen würde.</translation>
    </message>
    <message>
        <source>Describe the board on the page Board, and print it at 100 %. Check the scale bar with a ruler, and glue the sheet to something stiff and flat. If you already have a board, just describe it and go on to the next step.</source>
        <translation>Beschreiben Sie die Kalibriertafel auf der Seite Tafel und drucken Sie sie mit 100 %. Prüfen Sie den Maßstab mit einem Lineal und kleben Sie das Blatt auf etwas Steifes und Ebenes. Wenn Sie schon eine Tafel haben, beschreiben Sie sie nur und gehen Sie zum nächsten Schritt.</translation>
    </message>
    <message>
        <source>On the page Board, choose Intrinsics. With live cameras, press Start and show the board to each camera: close, tilted to all sides, and in the corners of the image. Hold it still each time. If you have already recorded this, just press Calibrate.</source>
        <translation>Wählen Sie auf der Seite Tafel die intrinsischen Parameter. Mit angeschlossenen Kameras drücken Sie Beginnen und zeigen jeder Kamera die Tafel: nah, nach allen Seiten geneigt und in den Ecken des Bildes. Halten Sie sie jedes Mal still. Wenn Sie das schon aufgenommen haben, drücken Sie nur Kalibrieren.</translation>
    </message>
    <message>
        <source>Enter the field of view or the focal length of each camera, for example from its data sheet. Calibrating the lens with a board is more accurate, but you do not need it to begin.</source>
        <translation>Geben Sie den Bildwinkel oder die Brennweite jeder Kamera ein, zum Beispiel aus dem Datenblatt. Das Objektiv mit einer Tafel zu kalibrieren ist genauer, aber für den Anfang nicht nötig.</translation>
    </message>
    <message>
        <source>Give the grid the size of a real object that you have measured. In each image, drag the grid until it lies on this object. Click a point of the grid to hold it in place.</source>
        <translation>Geben Sie dem Gitter die Größe eines wirklichen Gegenstands, den Sie gemessen haben. Ziehen Sie das Gitter in jedem Bild, bis es auf diesem Gegenstand liegt. Klicken Sie einen Punkt des Gitters an, um ihn festzuhalten.</translation>
    </message>
    <message>
        <source>Add points whose positions in the room you have measured, in meters. Then click each point in the images. Each camera needs at least four points, or better six that do not all lie in one plane.</source>
        <translation>Fügen Sie Punkte hinzu, deren Positionen im Raum Sie gemessen haben, in Metern. Klicken Sie dann jeden Punkt in den Bildern an. Jede Kamera braucht mindestens vier Punkte, besser sechs, die nicht alle in einer Ebene liegen.</translation>
    </message>
    <message>
        <source>Press Compute cameras below the table of points. If a point fits badly, the page tells you which one.</source>
        <translation>Drücken Sie Kameras berechnen unter der Punkttabelle. Passt ein Punkt schlecht, sagt Ihnen die Seite, welcher es ist.</translation>
    </message>
    <message>
        <source>On the page Board, choose Camera positions. With live cameras, press Start and show the board to at least two cameras at a time, in many parts of the volume. Lay it on the floor once, and press Set floor from board. If you have already recorded this, enter the frame with the board on the floor and press Calibrate.</source>
        <translation>Wählen Sie auf der Seite Tafel die Kamerapositionen. Mit angeschlossenen Kameras drücken Sie Beginnen und zeigen die Tafel mindestens zwei Kameras gleichzeitig, in vielen Teilen des Raums. Legen Sie sie einmal auf den Boden und drücken Sie Boden aus Tafel setzen. Wenn Sie das schon aufgenommen haben, geben Sie das Bild mit der Tafel auf dem Boden an und drücken Sie Kalibrieren.</translation>
    </message>
    <message>
        <source>Drag the grid in each image, or the cameras in the bird&apos;s-eye view, until each camera is within about 12 cm of its real position.</source>
        <translation>Ziehen Sie das Gitter in jedem Bild oder die Kameras in der Vogelperspektive, bis jede Kamera höchstens etwa 12 cm von ihrer wirklichen Position entfernt ist.</translation>
    </message>
    <message>
        <source>On the page Wand, choose what you wave and where the scale comes from. With live cameras, press Start waving and wave slowly through the whole volume for half a minute. Then press Refine cameras. If you have already recorded this, just press Refine cameras.</source>
        <translation>Geben Sie auf der Seite Stab an, was Sie schwenken und woher der Maßstab kommt. Mit angeschlossenen Kameras drücken Sie Schwenken beginnen und schwenken eine halbe Minute lang langsam durch den ganzen Raum. Drücken Sie dann Kameras verfeinern. Wenn Sie das schon aufgenommen haben, drücken Sie nur Kameras verfeinern.</translation>
    </message>
    <message>
        <source>Mark three points of the floor as A, B and C, each in at least two images. A becomes the origin, and the x axis points from A to B. Then press Set floor from A, B and C.</source>
        <translation>Markieren Sie drei Punkte des Bodens als A, B und C, jeden in mindestens zwei Bildern. A wird der Ursprung, und die x-Achse zeigt von A nach B. Drücken Sie dann Boden aus A, B und C festlegen.</translation>
    </message>
    <message>
        <source>Measure a distance in the room, as long as possible. Mark its ends as A and B, enter the distance, and press Check. If the calibration gives a different distance, press Set scale to correct the calibration.</source>
        <translation>Messen Sie eine möglichst lange Strecke im Raum. Markieren Sie ihre Enden als A und B, geben Sie die Länge ein und drücken Sie Prüfen. Ergibt die Kalibrierung eine andere Länge, drücken Sie Maßstab festlegen, um die Kalibrierung zu berichtigen.</translation>
    </message>
    <message>
        <source>Done: the distance in the calibration differs from the measured one by %1.</source>
        <translation>Erledigt: Die Länge in der Kalibrierung weicht um %1 von der gemessenen ab.</translation>
    </message>
    <message>
        <source>Done for %1 of %2 cameras.</source>
        <translation>Erledigt für %1 von %2 Kameras.</translation>
    </message>
    <message>
        <source>Done for %1 of %2 cameras. The largest error is %3.</source>
        <translation>Erledigt für %1 von %2 Kameras. Der größte Fehler ist %3.</translation>
    </message>
    <message>
        <source>You need a tape measure and points that the cameras see: at least four for each camera, better six. Choose this for cameras that are mounted in a room.</source>
        <translation>Sie brauchen ein Maßband und Punkte, die die Kameras sehen: mindestens vier für jede Kamera, besser sechs. Wählen Sie diesen Weg für Kameras, die fest in einem Raum montiert sind.</translation>
    </message>
</context>
<context>
    <name>MapLegend</name>
    <message>
        <source>%1 or more</source>
        <translation>%1 oder mehr</translation>
    </message>
    <message>
        <source>blank: seen by fewer than two cameras</source>
        <translation>leer: von weniger als zwei Kameras gesehen</translation>
    </message>
    <message>
        <source>Cameras that see a point</source>
        <translation>Kameras, die einen Punkt sehen</translation>
    </message>
    <message>
        <source>Expected error (1 σ)</source>
        <translation>Erwarteter Fehler (1 σ)</translation>
    </message>
    <message>
        <source>blank: seen by no camera</source>
        <translation>leer: von keiner Kamera gesehen</translation>
    </message>
</context>
<context>
    <name>MapOverlay</name>
    <message>
        <source>Cameras that see this point: %1</source>
        <translation>Kameras, die diesen Punkt sehen: %1</translation>
    </message>
    <message>
        <source>Expected error: ±%1 (1 σ); cameras that see this point: %2</source>
        <translation>Erwarteter Fehler: ±%1 (1 σ); Kameras, die diesen Punkt sehen: %2</translation>
    </message>
</context>
<context>
    <name>Method</name>
    <message>
        <source>Any object in the images of one camera (2D)</source>
        <translation>Beliebige Objekte in den Bildern einer Kamera (2D)</translation>
    </message>
    <message>
        <source>A particle filter with color histograms</source>
        <translation>Ein Partikelfilter mit Farbhistogrammen</translation>
    </message>
    <message>
        <source>A particle filter with position measurements</source>
        <translation>Ein Partikelfilter mit Positionsmessungen</translation>
    </message>
    <message>
        <source>A simple particle filter with color</source>
        <translation>Ein einfacher Partikelfilter mit Farbe</translation>
    </message>
    <message>
        <source>Colored objects in 3D</source>
        <translation>Farbige Objekte in 3D</translation>
    </message>
    <message>
        <source>Anything you draw a box around</source>
        <translation>Alles, worum Sie einen Rahmen ziehen</translation>
    </message>
    <message>
        <source>Balls, hands and other colored objects</source>
        <translation>Bälle, Hände und andere farbige Objekte</translation>
    </message>
    <message>
        <source>For comparison: mixes up people who come close to each other.</source>
        <translation>Zum Vergleich: verwechselt Personen, die sich nahe kommen.</translation>
    </message>
    <message>
        <source>For comparison: distinguishes people by their clothes.</source>
        <translation>Zum Vergleich: unterscheidet Personen an ihrer Kleidung.</translation>
    </message>
    <message>
        <source>For teaching: tracks an object as a box in the images of one camera.</source>
        <translation>Für die Lehre: verfolgt ein Objekt als Rahmen in den Bildern einer Kamera.</translation>
    </message>
    <message>
        <source>For teaching: shows how a particle filter works.</source>
        <translation>Für die Lehre: zeigt, wie ein Partikelfilter arbeitet.</translation>
    </message>
    <message>
        <source>For teaching: shows how particles follow measured positions.</source>
        <translation>Für die Lehre: zeigt, wie Partikel gemessenen Positionen folgen.</translation>
    </message>
    <message>
        <source>From papers, for teaching and comparison</source>
        <translation>Aus Artikeln, für Lehre und Vergleich</translation>
    </message>
    <message>
        <source>People by motion alone</source>
        <translation>Personen nur nach Bewegung</translation>
    </message>
    <message>
        <source>People by motion and color</source>
        <translation>Personen nach Bewegung und Farbe</translation>
    </message>
    <message>
        <source>People in a room</source>
        <translation>Personen in einem Raum</translation>
    </message>
    <message>
        <source>People who walk and meet</source>
        <translation>Personen, die gehen und sich treffen</translation>
    </message>
    <message>
        <source>Tracks several people on the floor, even in similar clothes.</source>
        <translation>Verfolgt mehrere Personen auf dem Boden, auch in ähnlicher Kleidung.</translation>
    </message>
    <message>
        <source>The most accurate method. It finds out by itself whether the target is a ball or has another shape.</source>
        <translation>Das genaueste Verfahren. Es stellt selbst fest, ob das Ziel ein Ball ist oder eine andere Form hat.</translation>
    </message>
    <message>
        <source>Tracks an object by its colors, adapts to its size, and finds it again after it was hidden.</source>
        <translation>Verfolgt ein Objekt an seinen Farben, passt sich seiner Größe an und findet es wieder, wenn es verdeckt war.</translation>
    </message>
</context>
<context>
    <name>MethodObstacle</name>
    <message>
        <source>Needs calibrated cameras.</source>
        <translation>Braucht kalibrierte Kameras.</translation>
    </message>
    <message>
        <source>Needs at least two cameras.</source>
        <translation>Braucht mindestens zwei Kameras.</translation>
    </message>
</context>
<context>
    <name>OutletText</name>
    <message>
        <source>JSON lines at %1</source>
        <translation>JSON-Zeilen unter %1</translation>
    </message>
    <message>
        <source>Web page and WebSocket at %1</source>
        <translation>Webseite und WebSocket unter %1</translation>
    </message>
    <message>
        <source>OSC messages to %1</source>
        <translation>OSC-Nachrichten an %1</translation>
    </message>
    <message>
        <source>TUIO cursors to %1</source>
        <translation>TUIO-Cursor an %1</translation>
    </message>
    <message>
        <source>CSV lines to the standard output</source>
        <translation>CSV-Zeilen an die Standardausgabe</translation>
    </message>
    <message>
        <source>CSV lines to %1</source>
        <translation>CSV-Zeilen an %1</translation>
    </message>
    <message>
        <source>No program is reading this pipe.</source>
        <translation>Kein Programm liest aus dieser Pipe.</translation>
    </message>
    <message>
        <source>Nothing can be written: %1</source>
        <translation>Es kann nicht geschrieben werden: %1</translation>
    </message>
</context>
<context>
    <name>PageText</name>
    <message>
        <source>Dewpoint live</source>
        <translation>Dewpoint live</translation>
    </message>
    <message>
        <source>Cameras, targets and their tracks in 3D</source>
        <translation>Kameras, Ziele und ihre Spuren in 3D</translation>
    </message>
    <message>
        <source>Drag: rotate · Wheel or two fingers: zoom · Double click: reset</source>
        <translation>Ziehen: drehen · Mausrad oder zwei Finger: zoomen · Doppelklick: zurücksetzen</translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation>Verbindung wird hergestellt …</translation>
    </message>
    <message>
        <source>Connected. Waiting for images…</source>
        <translation>Verbunden. Warten auf Bilder …</translation>
    </message>
    <message>
        <source>Not connected. Trying again…</source>
        <translation>Nicht verbunden. Neuer Versuch …</translation>
    </message>
    <message>
        <source>Frame %1, %2</source>
        <extracomment>%1 is the number of a frame, %2 its time</extracomment>
        <translation>Bild %1, %2</translation>
    </message>
    <message>
        <source>tracking</source>
        <translation>verfolgt</translation>
    </message>
    <message>
        <source>ambiguous</source>
        <translation>mehrdeutig</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verdeckt</translation>
    </message>
    <message>
        <source>searching</source>
        <translation>sucht</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>not present</source>
        <translation>nicht anwesend</translation>
    </message>
    <message>
        <source>Only pages from this server can read the results.</source>
        <translation>Nur Seiten von diesem Server können die Ergebnisse lesen.</translation>
    </message>
    <message>
        <source>Only GET requests are supported.</source>
        <translation>Nur GET-Anfragen werden unterstützt.</translation>
    </message>
    <message>
        <source>This server has only one page: /.</source>
        <translation>Dieser Server hat nur eine Seite: /.</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Half the x size of the start box: the particles start evenly spread in this box; 0 starts them all at the same x.</source>
        <translation>Halbe x-Ausdehnung des Startquaders: Die Partikel beginnen gleichmäßig in ihm verteilt; bei 0 beginnen alle beim selben x.</translation>
    </message>
    <message>
        <source>Half the y size of the start box: the particles start evenly spread in this box; 0 starts them all at the same y.</source>
        <translation>Halbe y-Ausdehnung des Startquaders: Die Partikel beginnen gleichmäßig in ihm verteilt; bei 0 beginnen alle beim selben y.</translation>
    </message>
    <message>
        <source>Half the z size of the start box: the particles start evenly spread in this box; 0 starts them all at the same z.</source>
        <translation>Halbe z-Ausdehnung des Startquaders: Die Partikel beginnen gleichmäßig in ihm verteilt; bei 0 beginnen alle beim selben z.</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis in one iteration: larger values follow faster objects, but spread the particles wider.</source>
        <translation>Wie weit sich Partikel in einer Iteration zufällig entlang jeder Achse bewegen: Größere Werte folgen schnelleren Objekten und streuen weiter.</translation>
    </message>
    <message>
        <source>How many filter iterations run on each frame.</source>
        <translation>Wie viele Filteriterationen auf jedem Bild laufen.</translation>
    </message>
    <message>
        <source>Number of particles of the filter: more particles track more reliably, but take more time.</source>
        <translation>Zahl der Partikel des Filters: Mehr Partikel verfolgen zuverlässiger, kosten aber mehr Zeit.</translation>
    </message>
    <message>
        <source>Iterations per frame</source>
        <translation>Iterationen je Bild</translation>
    </message>
    <message>
        <source>Motion sigma</source>
        <translation>Bewegungs-Sigma</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>Partikel</translation>
    </message>
    <message>
        <source>World x coordinate of the center of the box in which the particles start.</source>
        <translation>Welt-x-Koordinate der Mitte des Quaders, in dem die Partikel beginnen.</translation>
    </message>
    <message>
        <source>World y coordinate of the center of the box in which the particles start.</source>
        <translation>Welt-y-Koordinate der Mitte des Quaders, in dem die Partikel beginnen.</translation>
    </message>
    <message>
        <source>World z coordinate of the center of the box in which the particles start.</source>
        <translation>Welt-z-Koordinate der Mitte des Quaders, in dem die Partikel beginnen.</translation>
    </message>
    <message>
        <source>Acceleration sigma</source>
        <translation>Beschleunigungs-Sigma</translation>
    </message>
    <message>
        <source>Edge length of the space in which a target may appear: with larger values, a track is created only at a higher likelihood.</source>
        <translation>Kantenlänge des Raums, in dem ein Ziel auftauchen kann: Bei größeren Werten entsteht eine Spur erst bei höherer Likelihood.</translation>
    </message>
    <message>
        <source>How long a target still counts as present when no camera can see its expected position.</source>
        <translation>Wie lange ein Ziel noch als vorhanden gilt, wenn keine Kamera seine erwartete Position sehen kann.</translation>
    </message>
    <message>
        <source>Largest number of particles of each target.</source>
        <translation>Größte Zahl der Partikel je Ziel.</translation>
    </message>
    <message>
        <source>How strongly targets accelerate, brake and turn: larger values follow abrupt motion, smaller values bridge gaps better.</source>
        <translation>Wie stark Ziele beschleunigen, bremsen und abbiegen: Größere Werte folgen abrupten Bewegungen, kleinere überbrücken Lücken besser.</translation>
    </message>
    <message>
        <source>Search size</source>
        <translation>Suchraumgröße</translation>
    </message>
    <message>
        <source>Survival time</source>
        <translation>Überlebenszeit</translation>
    </message>
    <message>
        <source>Time budget</source>
        <translation>Zeitbudget</translation>
    </message>
    <message>
        <source>How long one iteration may take. To meet this limit, fewer particles are used and searches are spread over several frames. 0 sets no limit. With a limit, a run depends on the speed of the computer and cannot be repeated exactly.</source>
        <translation>Wie lange eine Iteration dauern darf. Um diese Grenze einzuhalten, werden weniger Partikel benutzt und Suchen über mehrere Bilder verteilt. 0 setzt keine Grenze. Mit einer Grenze hängt ein Lauf von der Geschwindigkeit des Rechners ab und lässt sich nicht exakt wiederholen.</translation>
    </message>
    <message>
        <source>Color adaptation</source>
        <translation>Farbanpassung</translation>
    </message>
    <message>
        <source>Time constant with which a target&apos;s color range follows slow changes of light, in each camera separately and only while the target is clearly visible. 0 keeps the range as it is; 2 is a good value in a room with daylight.</source>
        <translation>Zeitkonstante, mit der der Farbbereich eines Ziels langsamen Änderungen des Lichts folgt, in jeder Kamera für sich und nur, solange das Ziel deutlich zu sehen ist. 0 lässt den Bereich, wie er ist; 2 ist ein guter Wert in einem Raum mit Tageslicht.</translation>
    </message>
    <message>
        <source>Assumed error of a measured position along each axis: larger values trust the particles more, smaller values the measurement.</source>
        <translation>Angenommener Fehler einer gemessenen Position je Achse: Größere Werte vertrauen mehr den Partikeln, kleinere der Messung.</translation>
    </message>
    <message>
        <source>Observation sigma</source>
        <translation>Beobachtungs-Sigma</translation>
    </message>
    <message>
        <source>Adaptation</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Aspect sigma</source>
        <translation>Seitenverhältnis-Sigma</translation>
    </message>
    <message>
        <source>Min. color share</source>
        <translation>Min. Farbanteil</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis between images, in multiples of the target size, in addition to their constant velocity.</source>
        <translation>Wie weit sich Partikel von Bild zu Bild entlang jeder Achse zufällig bewegen, in Vielfachen der Zielgröße, zusätzlich zu ihrer gleichbleibenden Geschwindigkeit.</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis between images, in addition to their constant velocity: larger values follow sudden motion, but spread the particles wider.</source>
        <translation>Wie weit sich Partikel von Bild zu Bild entlang jeder Achse zufällig bewegen, zusätzlich zu ihrer gleichbleibenden Geschwindigkeit: Größere Werte folgen plötzlichen Bewegungen, streuen aber weiter.</translation>
    </message>
    <message>
        <source>How strongly positions with more of the target&apos;s colors are preferred.</source>
        <translation>Wie stark Positionen mit mehr Farben des Ziels bevorzugt werden.</translation>
    </message>
    <message>
        <source>Jump reach</source>
        <translation>Reichweite der Sprünge</translation>
    </message>
    <message>
        <source>Jump share</source>
        <translation>Anteil der Sprünge</translation>
    </message>
    <message>
        <source>Likelihood sigma</source>
        <translation>Likelihood-Sigma</translation>
    </message>
    <message>
        <source>Position sigma</source>
        <translation>Orts-Sigma</translation>
    </message>
    <message>
        <source>Scale sigma</source>
        <translation>Größen-Sigma</translation>
    </message>
    <message>
        <source>How much of the box&apos;s current colors is blended into the reference colors after each image; 0 keeps the colors of the first image.</source>
        <translation>Wie viel von den aktuellen Farben des Rahmens in jedem Bild in die Vorlagefarben eingeht; 0 behält die Farben des ersten Bildes.</translation>
    </message>
    <message>
        <source>Share of the particles that jump to other positions at which the target&apos;s colors are found.</source>
        <translation>Anteil der Partikel, die an andere Positionen springen, an denen die Farben des Ziels gefunden werden.</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Schärfe</translation>
    </message>
    <message>
        <source>The target counts as hidden and keeps its position if less than this share of its usual colors is found.</source>
        <translation>Das Ziel gilt als verdeckt und behält seine Position, wenn weniger als dieser Anteil seiner üblichen Farben gefunden wird.</translation>
    </message>
    <message>
        <source>Time after which a new object that stays in place counts as background.</source>
        <translation>Zeit, nach der ein neues Objekt, das am Ort bleibt, als Hintergrund gilt.</translation>
    </message>
    <message>
        <source>Half width of the area, x</source>
        <translation>Fläche: halbe Größe x</translation>
    </message>
    <message>
        <source>Half width of the area, y</source>
        <translation>Fläche: halbe Größe y</translation>
    </message>
    <message>
        <source>Area x</source>
        <translation>Fläche x</translation>
    </message>
    <message>
        <source>Area y</source>
        <translation>Fläche y</translation>
    </message>
    <message>
        <source>Background memory</source>
        <translation>Hintergrundgedächtnis</translation>
    </message>
    <message>
        <source>Background model</source>
        <translation>Hintergrundmodell</translation>
    </message>
    <message>
        <source>Confirmation time</source>
        <translation>Bestätigungszeit</translation>
    </message>
    <message>
        <source>Create tracks</source>
        <translation>Neue Personen</translation>
    </message>
    <message>
        <source>Body points</source>
        <translation>Körperpunkte</translation>
    </message>
    <message>
        <source>Color noise</source>
        <translation>Farbrauschen</translation>
    </message>
    <message>
        <source>Color weight</source>
        <translation>Farbgewicht</translation>
    </message>
    <message>
        <source>Darkest shadow</source>
        <translation>Dunkelster Schatten</translation>
    </message>
    <message>
        <source>Weight per camera</source>
        <translation>Gewicht je Kamera</translation>
    </message>
    <message>
        <source>Floor z</source>
        <translation>Boden z</translation>
    </message>
    <message>
        <source>Assumed height of a person whose height is not known yet.</source>
        <translation>Angenommene Größe einer Person, deren Größe noch nicht bekannt ist.</translation>
    </message>
    <message>
        <source>Height of the floor in world coordinates.</source>
        <translation>Höhe des Bodens in Weltkoordinaten.</translation>
    </message>
    <message>
        <source>How long a person still counts as present when fewer than two cameras see the person.</source>
        <translation>Wie lange eine Person noch als anwesend gilt, wenn weniger als zwei Kameras sie sehen.</translation>
    </message>
    <message>
        <source>Number of particles of each person.</source>
        <translation>Zahl der Partikel jeder Person.</translation>
    </message>
    <message>
        <source>Number of points that represent the volume of each person.</source>
        <translation>Zahl der Punkte, die das Volumen jeder Person darstellen.</translation>
    </message>
    <message>
        <source>How much the colors of clothes count compared with the masks when people are close to each other.</source>
        <translation>Wie viel die Farben der Kleidung im Vergleich zu den Masken zählen, wenn Personen sich nahe sind.</translation>
    </message>
    <message>
        <source>Smallest distance between the centers of two people.</source>
        <translation>Kleinster Abstand zwischen den Mitten zweier Personen.</translation>
    </message>
    <message>
        <source>How strongly people accelerate, brake and turn.</source>
        <translation>Wie stark Personen beschleunigen, bremsen und abbiegen.</translation>
    </message>
    <message>
        <source>Min. hue likelihood</source>
        <translation>Kleinste Farbton-Likelihood</translation>
    </message>
    <message>
        <source>Hue sigma</source>
        <translation>Farbton-Sigma</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>Bildbreite</translation>
    </message>
    <message>
        <source>Images are reduced to at most this width before they are analyzed; 0 keeps them as they are.</source>
        <translation>Bilder werden vor der Auswertung auf höchstens diese Breite verkleinert; 0 lässt sie, wie sie sind.</translation>
    </message>
    <message>
        <source>Learning time</source>
        <translation>Lernzeit</translation>
    </message>
    <message>
        <source>Minimum distance</source>
        <translation>Mindestabstand</translation>
    </message>
    <message>
        <source>Lower limit of the likelihood of a pixel&apos;s hue (h_B in the paper); above 0 because another object may hide the person.</source>
        <translation>Untere Grenze der Likelihood des Farbtons eines Pixels (h_B im Artikel); über 0, weil ein anderes Objekt die Person verdecken kann.</translation>
    </message>
    <message>
        <source>Lower limit of the likelihood of a pixel&apos;s saturation (s_B in the paper).</source>
        <translation>Untere Grenze der Likelihood der Sättigung eines Pixels (s_B im Artikel).</translation>
    </message>
    <message>
        <source>Smallest likelihood where a camera sees no motion (p_B in the paper: 0.2).</source>
        <translation>Kleinste Likelihood, wo eine Kamera keine Bewegung sieht (p_B im Artikel: 0,2).</translation>
    </message>
    <message>
        <source>Mask smoothing</source>
        <translation>Maskenglättung</translation>
    </message>
    <message>
        <source>Min. motion likelihood</source>
        <translation>Kleinste Bewegungs-Likelihood</translation>
    </message>
    <message>
        <source>Position noise</source>
        <translation>Ortsrauschen</translation>
    </message>
    <message>
        <source>Min. saturation likelihood</source>
        <translation>Kleinste Sättigungs-Likelihood</translation>
    </message>
    <message>
        <source>Saturation sigma</source>
        <translation>Sättigungs-Sigma</translation>
    </message>
    <message>
        <source>Sigma of the Gaussian that smooths the motion masks (the paper: 4 px).</source>
        <translation>Sigma der Gauß-Glättung der Bewegungsmasken (im Artikel: 4 px).</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on each component of the velocity, per frame.</source>
        <translation>Standardabweichung des Rauschens auf jeder Komponente der Geschwindigkeit, je Bild.</translation>
    </message>
    <message>
        <source>Standard deviation of the random motion that is added to each coordinate of a particle, per frame.</source>
        <translation>Standardabweichung der zufälligen Bewegung, die jeder Koordinate eines Partikels hinzugefügt wird, je Bild.</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on hue and saturation, per frame.</source>
        <translation>Standardabweichung des Rauschens auf Farbton und Sättigung, je Bild.</translation>
    </message>
    <message>
        <source>Usual height</source>
        <translation>Übliche Größe</translation>
    </message>
    <message>
        <source>Velocity noise</source>
        <translation>Geschwindigkeitsrauschen</translation>
    </message>
    <message>
        <source>Calibration error</source>
        <translation>Fehler der Kalibrierung</translation>
    </message>
    <message>
        <source>Error of the directions in which the cameras see objects. It is part of the reported uncertainty of a position. 0.25 suits a calibration by hand.</source>
        <translation>Fehler der Richtungen, in denen die Kameras Objekte sehen. Er ist Teil der angegebenen Unsicherheit einer Position. 0,25 passt zu einer Kalibrierung von Hand.</translation>
    </message>
    <message>
        <source>Time error</source>
        <translation>Fehler der Zeit</translation>
    </message>
    <message>
        <source>1 tracks every person that several cameras see. 0 tracks only people that you add by hand.</source>
        <translation>1 verfolgt jede Person, die mehrere Kameras sehen. 0 verfolgt nur Personen, die Sie von Hand hinzufügen.</translation>
    </message>
    <message>
        <source>Coordinate of the center of the tracked floor area along this axis.</source>
        <translation>Koordinate der Mitte der verfolgten Bodenfläche entlang dieser Achse.</translation>
    </message>
    <message>
        <source>Error of the times at which the images were taken. It is part of the reported uncertainty of a moving target. 8 suits webcams.</source>
        <translation>Fehler der Zeiten, zu denen die Bilder aufgenommen wurden. Er ist Teil der angegebenen Unsicherheit eines bewegten Ziels. 8 passt zu Webcams.</translation>
    </message>
    <message>
        <source>Half the size of the tracked floor area along this axis. A person who crosses the border of the area counts as having left.</source>
        <translation>Halbe Größe der beobachteten Bodenfläche entlang dieser Achse. Eine Person, die den Rand der Fläche überschreitet, gilt als gegangen.</translation>
    </message>
    <message>
        <source>How far the particles may deviate from the distribution that they represent (Kullback-Leibler divergence). A smaller value uses more particles when the cloud is spread out; 0 always uses the largest number.</source>
        <translation>Wie weit die Partikel von der Verteilung abweichen dürfen, die sie darstellen (Kullback-Leibler-Divergenz). Ein kleinerer Wert benutzt mehr Partikel, wenn die Wolke weit gestreut ist; 0 benutzt immer die größte Anzahl.</translation>
    </message>
    <message>
        <source>How far the target may be from its predicted position, in multiples of the target size. Positions that are farther away count as unlikely.</source>
        <translation>Wie weit das Ziel von seiner vorhergesagten Position entfernt sein darf, in Vielfachen der Zielgröße. Weiter entfernte Positionen gelten als unwahrscheinlich.</translation>
    </message>
    <message>
        <source>How long a moving region that belongs to no tracked person must be visible before a new track is created.</source>
        <translation>Wie lange ein bewegter Bereich, der zu keiner verfolgten Person gehört, sichtbar sein muss, bevor eine neue Spur entsteht.</translation>
    </message>
    <message>
        <source>How long the cameras only learn the background at the start. Nobody should be in view during this time.</source>
        <translation>Wie lange die Kameras am Anfang nur den Hintergrund lernen. In dieser Zeit sollte niemand im Bild sein.</translation>
    </message>
    <message>
        <source>How moving regions are found. 0: one Gaussian for each pixel (fast). 1: MOG2 of OpenCV. 2: KNN of OpenCV.</source>
        <translation>Wie bewegte Bereiche gefunden werden. 0: eine Normalverteilung je Pixel (schnell). 1: MOG2 von OpenCV. 2: KNN von OpenCV.</translation>
    </message>
    <message>
        <source>How strongly the mask of each camera influences where a person is tracked: larger values rely more on the masks.</source>
        <translation>Wie stark die Maske jeder Kamera beeinflusst, wo eine Person verfolgt wird: Größere Werte vertrauen den Masken mehr.</translation>
    </message>
    <message>
        <source>How much the colors of a particle&apos;s box may differ from the reference colors (Bhattacharyya distance): smaller values trust the best particles more.</source>
        <translation>Wie sehr die Farben im Rahmen eines Partikels von den Farben der Vorlage abweichen dürfen (Bhattacharyya-Abstand): Kleinere Werte trauen den besten Partikeln mehr.</translation>
    </message>
    <message>
        <source>How much the ratio of width to height may change between images, as the standard deviation of its logarithm; 0 keeps the initial ratio.</source>
        <translation>Wie sehr sich das Verhältnis von Breite zu Höhe von Bild zu Bild ändern darf, als Standardabweichung seines Logarithmus; 0 behält das anfängliche Verhältnis.</translation>
    </message>
    <message>
        <source>How much the size of the box may change between images, as the standard deviation of its logarithm; 0 keeps the initial size.</source>
        <translation>Wie sehr sich die Größe des Rahmens von Bild zu Bild ändern darf, als Standardabweichung ihres Logarithmus; 0 behält die anfängliche Größe.</translation>
    </message>
    <message>
        <source>Lowest brightness of a shadow, as a share of the background&apos;s brightness at the same hue. Anything darker counts as a moving region.</source>
        <translation>Kleinste Helligkeit eines Schattens, als Anteil der Helligkeit des Hintergrunds bei gleichem Farbton. Alles Dunklere gilt als bewegter Bereich.</translation>
    </message>
    <message>
        <source>Smallest number of particles of each target; used when all its particles are close together.</source>
        <translation>Kleinste Zahl der Partikel je Ziel, benutzt, wenn alle Partikel dicht beieinander liegen.</translation>
    </message>
    <message>
        <source>Standard deviation of a measured hue; hues range from 0 to 1.</source>
        <translation>Standardabweichung eines gemessenen Farbtons; Farbtöne reichen von 0 bis 1.</translation>
    </message>
    <message>
        <source>Standard deviation of a measured saturation; saturations range from 0 to 1.</source>
        <translation>Standardabweichung einer gemessenen Sättigung; Sättigungen reichen von 0 bis 1.</translation>
    </message>
    <message>
        <source>Delay spread</source>
        <translation>Streuung der Verzögerungen</translation>
    </message>
    <message>
        <source>How much the delays of the cameras may differ (standard deviation). While a target moves, the delays are estimated and corrected. 0 if all time stamps are exact: then no delay is estimated.</source>
        <translation>Wie stark sich die Verzögerungen der Kameras unterscheiden können (Standardabweichung). Während sich ein Ziel bewegt, werden die Verzögerungen geschätzt und korrigiert. 0, wenn alle Zeitstempel genau sind: Dann wird keine Verzögerung geschätzt.</translation>
    </message>
    <message>
        <source>KLD error</source>
        <translation>KLD-Fehler</translation>
    </message>
    <message>
        <source>Minimum particles</source>
        <translation>Mindestzahl der Partikel</translation>
    </message>
    <message>
        <source>Start box, center x</source>
        <translation>Startquader, Mitte x</translation>
    </message>
    <message>
        <source>Start box, center y</source>
        <translation>Startquader, Mitte y</translation>
    </message>
    <message>
        <source>Start box, center z</source>
        <translation>Startquader, Mitte z</translation>
    </message>
    <message>
        <source>Start box, half width x</source>
        <translation>Startquader, halbe Breite x</translation>
    </message>
    <message>
        <source>Start box, half width y</source>
        <translation>Startquader, halbe Breite y</translation>
    </message>
    <message>
        <source>Start box, half width z</source>
        <translation>Startquader, halbe Breite z</translation>
    </message>
</context>
<context>
    <name>ParameterGroup</name>
    <message>
        <source>Area and people</source>
        <translation>Fläche und Personen</translation>
    </message>
    <message>
        <source>Essential</source>
        <translation>Wesentliches</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Für Fachleute</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Search and start</source>
        <translation>Suche und Start</translation>
    </message>
</context>
<context>
    <name>ParameterRow</name>
    <message>
        <source>%1
From %2 to %3%4; default %5%4.</source>
        <translation>%1
Von %2 bis %3%4; Vorgabe %5%4.</translation>
    </message>
    <message>
        <source>%1
From %2 to %3%4; the default comes from the region that the cameras see.</source>
        <translation>%1
Von %2 bis %3%4; die Vorgabe kommt aus dem Bereich, den die Kameras sehen.</translation>
    </message>
    <message>
        <source>Changed: the default is %1.</source>
        <translation>Geändert: Die Vorgabe ist %1.</translation>
    </message>
    <message>
        <source>Reset to %1 (Backspace on the slider)</source>
        <translation>Auf %1 zurücksetzen (Rücktaste auf dem Schieberegler)</translation>
    </message>
</context>
<context>
    <name>People</name>
    <message>
        <source>learning background: %1 % · keep the scene empty</source>
        <translation>lernt Hintergrund: %1 % · bitte nicht ins Bild treten</translation>
    </message>
    <message>
        <source>image ignored: %1 % of it is moving</source>
        <translation>Bild ignoriert: %1 % davon bewegen sich</translation>
    </message>
    <message>
        <source>learning: %1 %</source>
        <translation>lernt: %1 %</translation>
    </message>
</context>
<context>
    <name>PlotAxisStrip</name>
    <message>
        <source>seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>iteration</source>
        <translation>Iteration</translation>
    </message>
</context>
<context>
    <name>PlotFigure</name>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>filter iteration</source>
        <translation>Filteriteration</translation>
    </message>
    <message>
        <source>Dewpoint plots</source>
        <translation>Dewpoint-Kurven</translation>
    </message>
</context>
<context>
    <name>PlotQuantity</name>
    <message>
        <source>%1 (%2)</source>
        <comment>title of a plot, unit of its axis</comment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>PlotReadout</name>
    <message>
        <source>truth</source>
        <translation>Wahrheit</translation>
    </message>
</context>
<context>
    <name>Quantity</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
</context>
<context>
    <name>Reason</name>
    <message>
        <source>no image</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>camera covered or moved</source>
        <translation>Kamera verdeckt oder bewegt</translation>
    </message>
    <message>
        <source>too dark</source>
        <translation>zu dunkel</translation>
    </message>
    <message>
        <source>out of view</source>
        <translation>außer Sicht</translation>
    </message>
    <message>
        <source>partly hidden</source>
        <translation>teilweise verdeckt</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verdeckt</translation>
    </message>
    <message>
        <source>at a distractor</source>
        <translation>bei einem Störobjekt</translation>
    </message>
    <message>
        <source>%1 away from a distractor</source>
        <translation>%1 von einem Störobjekt entfernt</translation>
    </message>
    <message>
        <source>no matching color</source>
        <translation>keine passende Farbe</translation>
    </message>
    <message>
        <source>color found %1 away</source>
        <translation>Farbe %1 entfernt gefunden</translation>
    </message>
    <message>
        <source>right color, wrong shape</source>
        <translation>richtige Farbe, falsche Form</translation>
    </message>
    <message>
        <source>hidden here</source>
        <translation>hier verdeckt</translation>
    </message>
    <message>
        <source>not in this image</source>
        <translation>nicht in diesem Bild</translation>
    </message>
</context>
<context>
    <name>RunPlots</name>
    <message>
        <source>all cameras</source>
        <translation>alle Kameras</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>Effektive Stichprobengröße</translation>
    </message>
    <message>
        <source>effective</source>
        <translation>effektiv</translation>
    </message>
    <message>
        <source>particles</source>
        <translation>Partikel</translation>
    </message>
    <message>
        <source>Log likelihood</source>
        <translation>Log-Likelihood</translation>
    </message>
    <message>
        <source>Existence</source>
        <translation>Existenz</translation>
    </message>
    <message>
        <source>Error against ground truth</source>
        <translation>Abweichung von der wahren Position</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Time per step</source>
        <translation>Zeit pro Schritt</translation>
    </message>
    <message>
        <source>one iteration</source>
        <translation>eine Iteration</translation>
    </message>
    <message>
        <source>Similarity</source>
        <translation>Ähnlichkeit</translation>
    </message>
    <message>
        <source>similarity to the reference colors</source>
        <translation>Ähnlichkeit mit den Vorlagefarben</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>SizeFitText</name>
    <message>
        <source>same as during calibration</source>
        <translation>wie bei der Kalibrierung</translation>
    </message>
    <message>
        <source>cropped on all sides</source>
        <translation>auf allen Seiten beschnitten</translation>
    </message>
    <message>
        <source>cropped at the right and at the bottom</source>
        <translation>rechts und unten beschnitten</translation>
    </message>
    <message>
        <source>scaled</source>
        <translation>skaliert</translation>
    </message>
    <message>
        <source>rotated clockwise by 90°</source>
        <translation>um 90° im Uhrzeigersinn gedreht</translation>
    </message>
    <message>
        <source>rotated clockwise by 270°</source>
        <translation>um 270° im Uhrzeigersinn gedreht</translation>
    </message>
</context>
<context>
    <name>TakeText</name>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>Recording take %1</source>
        <translation>Aufnahme %1 läuft</translation>
    </message>
    <message numerus="yes">
        <source>%n dropped image(s)</source>
        <translation>
            <numerusform>%n verlorenes Bild</numerusform>
            <numerusform>%n verlorene Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>%1 frei</translation>
    </message>
    <message>
        <source>%1: %2 images, %3, %4 dropped, %5</source>
        <translation>%1: %2 Bilder, %3, %4 verloren, %5</translation>
    </message>
    <message>
        <source>The take contains %1 from before you pressed Record. There was not enough memory for more.</source>
        <translation>Die Aufnahme enthält %1 aus der Zeit vor dem Start; für mehr reichte der Speicher nicht.</translation>
    </message>
    <message>
        <source>The take contains %1 from before you pressed Record.</source>
        <translation>Die Aufnahme enthält %1 aus der Zeit vor dem Start.</translation>
    </message>
    <message>
        <source>The run began before the take, so the run cannot be tracked again from its beginning. To avoid this, restart the run while you record.</source>
        <translation>Der Lauf begann vor der Aufnahme und kann daher nicht von seinem Anfang an noch einmal verfolgt werden. Um das zu vermeiden, starten Sie den Lauf neu, während Sie aufnehmen.</translation>
    </message>
    <message>
        <source>Tracking the take gives exactly the results of the live run in all %1 frames.</source>
        <translation>Beim Verfolgen der Aufnahme ergeben sich in allen %1 Bildern exakt die Ergebnisse des Live-Laufs.</translation>
    </message>
    <message>
        <source>%1 of %2 frames differ from the live run, the first one is frame %3. Positions differ by up to %4.</source>
        <translation>%1 von %2 Bildern weichen vom Live-Lauf ab, als erstes Bild %3. Die Positionen unterscheiden sich um bis zu %4.</translation>
    </message>
    <message>
        <source>Images of %1 frames were dropped, the first in frame %2.</source>
        <translation>In %1 Bildern fehlen Kamerabilder, zuerst in Bild %2.</translation>
    </message>
    <message>
        <source>Frames %1 to %2 were tracked with other settings.</source>
        <translation>Die Bilder %1 bis %2 wurden mit anderen Einstellungen verfolgt.</translation>
    </message>
    <message>
        <source>A time budget is set, so results depend on the speed of the computer.</source>
        <translation>Ein Zeitbudget ist gesetzt, daher hängen die Ergebnisse von der Geschwindigkeit des Computers ab.</translation>
    </message>
    <message>
        <source>The images of %1 are stored with slightly different colors, because the camera sends them uncompressed.</source>
        <translation>Die Bilder von %1 sind mit leicht anderen Farben gespeichert, weil die Kamera sie unkomprimiert sendet.</translation>
    </message>
</context>
<context>
    <name>TargetPanel</name>
    <message>
        <source>%1, in %2
Center %3, %4, size %5 × %6
Similarity %7
Effective sample size %8 of %9</source>
        <translation>%1, in %2
Mitte %3, %4, Größe %5 × %6
Ähnlichkeit %7
Effektive Stichprobengröße %8 von %9</translation>
    </message>
    <message>
        <source>Spread %1</source>
        <translation>Streuung %1</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Frame %1, %2</source>
        <translation>Bild %1, %2</translation>
    </message>
    <message>
        <source>not tracked</source>
        <translation>nicht verfolgt</translation>
    </message>
    <message>
        <source>✕ %1</source>
        <translation>✕ %1</translation>
    </message>
    <message>
        <source>tracking frames %2 to %3 again: now at %1</source>
        <translation>verfolgt die Bilder %2 bis %3 erneut: jetzt bei %1</translation>
    </message>
    <message>
        <source>✕ no image</source>
        <translation>✕ kein Bild</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>korrigiert</translation>
    </message>
    <message>
        <source>tracked with earlier settings</source>
        <translation>mit früheren Einstellungen verfolgt</translation>
    </message>
    <message>
        <source>The state of each target appears here during tracking.</source>
        <translation>Der Zustand jedes Ziels erscheint hier während der Verfolgung.</translation>
    </message>
</context>
<context>
    <name>TrackingState</name>
    <message>
        <source>○ searching</source>
        <translation>○ sucht</translation>
    </message>
    <message>
        <source>▲ lost</source>
        <translation>▲ verloren</translation>
    </message>
    <message>
        <source>✕ missing</source>
        <translation>✕ fehlt</translation>
    </message>
    <message>
        <source>– no images</source>
        <translation>– keine Bilder</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>Noch kein Ziel</translation>
    </message>
    <message>
        <source>– not tracked</source>
        <translation>– nicht verfolgt</translation>
    </message>
    <message>
        <source>◌ hidden</source>
        <translation>◌ verdeckt</translation>
    </message>
    <message>
        <source>– no box</source>
        <translation>– kein Rahmen</translation>
    </message>
    <message>
        <source>◔ learning background</source>
        <translation>◔ lernt Hintergrund</translation>
    </message>
    <message>
        <source>◌ nobody in view</source>
        <translation>◌ niemand im Bild</translation>
    </message>
    <message>
        <source>– not present</source>
        <translation>– nicht anwesend</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ mehrdeutig</translation>
    </message>
    <message>
        <source>● tracking</source>
        <translation>● verfolgt</translation>
    </message>
</context>
<context>
    <name>TransportBar</name>
    <message>
        <source>Toolbar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Start</translation>
    </message>
</context>
<context>
    <name>Unit</name>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>m/s²</source>
        <translation>m/s²</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>sizes</source>
        <translation>Größen</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
</context>
<context>
    <name>VideoDialog</name>
    <message>
        <source>Frame %1</source>
        <translation>Frame %1</translation>
    </message>
</context>
<context>
    <name>WandSettings</name>
    <message>
        <source>The ball touches the floor</source>
        <translation>Der Ball berührt den Boden</translation>
    </message>
    <message>
        <source>The ball is at one end of the known distance</source>
        <translation>Der Ball ist am einen Ende der bekannten Strecke</translation>
    </message>
    <message>
        <source>The ball is at the other end of the known distance</source>
        <translation>Der Ball ist am anderen Ende der bekannten Strecke</translation>
    </message>
    <message>
        <source>First frame of the fall</source>
        <translation>Erstes Bild des Falls</translation>
    </message>
    <message>
        <source>Last frame of the fall</source>
        <translation>Letztes Bild des Falls</translation>
    </message>
    <message>
        <source>At least two cameras must see the ball.</source>
        <translation>Mindestens zwei Kameras müssen den Ball sehen.</translation>
    </message>
    <message>
        <source>The scale comes from a known distance: add the times at which the ball is at each end of this distance.</source>
        <translation>Der Maßstab kommt von einer bekannten Strecke: Fügen Sie die Zeitpunkte hinzu, zu denen der Ball an jedem Ende dieser Strecke ist.</translation>
    </message>
    <message>
        <source>To use a fall, add two times: the first and the last frame of the fall.</source>
        <translation>Für einen Fall fügen Sie zwei Zeitpunkte hinzu: das erste und das letzte Bild des Falls.</translation>
    </message>
    <message>
        <source>Both ends of the wand are the same target: choose another target for one of them.</source>
        <translation>Beide Enden des Stabs sind dasselbe Ziel: Wählen Sie für eines davon ein anderes Ziel.</translation>
    </message>
    <message>
        <source>Learn the color of the ball first: press “Learn the color” in the toolbar, then click the ball in an image.</source>
        <translation>Lernen Sie zuerst die Farbe des Balls: Drücken Sie „Farbe lernen“ in der Werkzeugleiste, und klicken Sie dann den Ball in einem Bild an.</translation>
    </message>
    <message>
        <source>A wand has two balls of different colors: press “Add a target” in the toolbar, then click the second ball in an image.</source>
        <translation>Ein Stab hat zwei Bälle verschiedener Farben: Drücken Sie „Ziel hinzufügen“ in der Werkzeugleiste, und klicken Sie dann den zweiten Ball in einem Bild an.</translation>
    </message>
    <message>
        <source>Also move the ball to the left part of the image of %1.</source>
        <translation>Bewegen Sie den Ball auch in den linken Teil des Bildes von %1.</translation>
    </message>
    <message>
        <source>Also move the ball to the right part of the image of %1.</source>
        <translation>Bewegen Sie den Ball auch in den rechten Teil des Bildes von %1.</translation>
    </message>
    <message>
        <source>Also move the ball to the upper part of the image of %1.</source>
        <translation>Bewegen Sie den Ball auch in den oberen Teil des Bildes von %1.</translation>
    </message>
    <message>
        <source>Also move the ball to the lower part of the image of %1.</source>
        <translation>Bewegen Sie den Ball auch in den unteren Teil des Bildes von %1.</translation>
    </message>
    <message>
        <source>Also move the ball to all edges of the image of %1.</source>
        <translation>Bewegen Sie den Ball auch an alle Ränder des Bildes von %1.</translation>
    </message>
    <message>
        <source>The ball was seen for only %1. Wave for half a minute.</source>
        <translation>Der Ball war nur %1 lang zu sehen. Schwenken Sie ihn eine halbe Minute lang.</translation>
    </message>
    <message>
        <source>The ball moved only along one line. Move it in all directions: to the sides, up and down, near and far.</source>
        <translation>Der Ball bewegte sich nur entlang einer Linie. Bewegen Sie ihn in alle Richtungen: zur Seite, nach oben und unten, nah und fern.</translation>
    </message>
    <message>
        <source>The ball moved only within a plane (%1 thick). Also move it across this plane: toward %2 and away from it.</source>
        <translation>Der Ball bewegte sich nur in einer Ebene (%1 dick). Bewegen Sie ihn auch quer zu dieser Ebene: auf %2 zu und davon weg.</translation>
    </message>
    <message>
        <source>The distance from %1 to the ball hardly changed (by only %2). Also move the ball toward %1 and away from it.</source>
        <translation>Die Entfernung von %1 zum Ball hat sich kaum geändert (nur um %2). Bewegen Sie den Ball auch auf %1 zu und davon weg.</translation>
    </message>
    <message>
        <source>The ball stayed in %1 of the volume that the cameras see together. Move it through the whole volume in which you will track.</source>
        <translation>Der Ball blieb in %1 des Raums, den die Kameras gemeinsam sehen. Bewegen Sie ihn durch den ganzen Raum, in dem Sie verfolgen werden.</translation>
    </message>
    <message>
        <source>%1 saw the ball in only %2 of its image.</source>
        <translation>%1 sah den Ball nur in %2 des Bildes.</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %2 saw the ball at the same time in only %n frame(s). Move the ball where both cameras see it.</source>
        <translation>
            <numerusform>%1 und %2 sahen den Ball nur in %n Bild gleichzeitig. Bewegen Sie ihn dort, wo beide Kameras ihn sehen.</numerusform>
            <numerusform>%1 und %2 sahen den Ball nur in %n Bildern gleichzeitig. Bewegen Sie ihn dort, wo beide Kameras ihn sehen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The cameras were calibrated before, and the motion in this recording is not enough to improve that calibration. Keep the previous calibration.</source>
        <translation>Die Kameras waren schon kalibriert, und die Bewegung in dieser Aufnahme reicht nicht aus, um diese Kalibrierung zu verbessern. Behalten Sie die bisherige Kalibrierung.</translation>
    </message>
    <message>
        <source>The old camera positions are known more accurately (±%1) than the new ones (±%2). Keep the old positions.</source>
        <translation>Die bisherigen Kamerapositionen sind genauer bekannt (±%1) als die neuen (±%2). Behalten Sie die bisherigen Positionen.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AboutDialog</name>
    <message>
        <source>Show license</source>
        <translation>Lizenz zeigen</translation>
    </message>
    <message>
        <source>Hide license</source>
        <translation>Lizenz verbergen</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Über Dewpoint</translation>
    </message>
    <message>
        <source>Dewpoint %1</source>
        <translation>Dewpoint %1</translation>
    </message>
    <message>
        <source>Tracks colored objects in 3D, live, from ordinary cameras with particle filters.</source>
        <translation>Verfolgt farbige Objekte in 3D, live, aus gewöhnlichen Kameras mit Partikelfiltern.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later (GPL-3.0-or-later), without any warranty.</source>
        <translation>Freie Software unter der GNU General Public License, Version 3 oder später (GPL-3.0-or-later), ohne jede Gewährleistung.</translation>
    </message>
    <message>
        <source>How to cite</source>
        <translation>So wird zitiert</translation>
    </message>
    <message>
        <source>Show or hide the full text of the license</source>
        <translation>Den ganzen Text der Lizenz zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Copy citation</source>
        <translation>Zitat kopieren</translation>
    </message>
    <message>
        <source>Copy the entry for your reference list</source>
        <translation>Den Eintrag für Ihr Literaturverzeichnis kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AddPersonTool</name>
    <message>
        <source>Click the person</source>
        <translation>Die Person anklicken</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter adds a person there</source>
        <translation>Bild von %1: Pfeiltasten bewegen ein Kreuz, Eingabe fügt dort eine Person hinzu</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AddressForm</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>Add a camera with this address to the project</source>
        <translation>Eine Kamera mit dieser Adresse zum Projekt hinzufügen</translation>
    </message>
    <message>
        <source>Make this address the image source of the selected camera</source>
        <translation>Diese Adresse zur Bildquelle der ausgewählten Kamera machen</translation>
    </message>
    <message>
        <source>Waiting for the first image…</source>
        <translation>Warten auf das erste Bild…</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>✓ %1</source>
        <translation>✓ %1</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>RTSP camera</source>
        <translation>RTSP-Kamera</translation>
    </message>
    <message>
        <source>MJPEG over HTTP</source>
        <translation>MJPEG über HTTP</translation>
    </message>
    <message>
        <source>RTP over UDP</source>
        <translation>RTP über UDP</translation>
    </message>
    <message>
        <source>SRT</source>
        <translation>SRT</translation>
    </message>
    <message>
        <source>GStreamer pipeline</source>
        <translation>GStreamer-Pipeline</translation>
    </message>
    <message>
        <source>Test pattern</source>
        <translation>Testbild</translation>
    </message>
    <message>
        <source>Kind of address</source>
        <translation>Art der Adresse</translation>
    </message>
    <message>
        <source>Shows what an address of this kind looks like</source>
        <translation>Zeigt, wie eine Adresse dieser Art aussieht</translation>
    </message>
    <message>
        <source>Address of the camera</source>
        <translation>Adresse der Kamera</translation>
    </message>
    <message>
        <source>Address of a network camera, a GStreamer pipeline or a test pattern</source>
        <translation>Adresse einer Netzwerkkamera, eine GStreamer-Pipeline oder ein Testbild</translation>
    </message>
    <message>
        <source>Open the address, and show the first image, its size and the frame rate</source>
        <translation>Die Adresse öffnen und das erste Bild, dessen Größe und die Bildrate zeigen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Assign to selected camera</source>
        <translation>Ausgewählter Kamera zuweisen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackgroundImageTaker</name>
    <message>
        <source>“%1” is visible in this image and would become part of the background. Choose a frame without this target.</source>
        <translation>„%1“ ist in diesem Bild zu sehen und würde Teil des Hintergrunds. Wählen Sie ein Bild ohne dieses Ziel.</translation>
    </message>
    <message>
        <source>Use image anyway</source>
        <translation>Bild trotzdem verwenden</translation>
    </message>
    <message>
        <source>The image was saved as %1, but is not used, because the settings of the camera were changed in the meantime.</source>
        <translation>Das Bild wurde als %1 gespeichert, wird aber nicht verwendet, weil die Einstellungen der Kamera inzwischen geändert wurden.</translation>
    </message>
    <message>
        <source>Change background image</source>
        <translation>Hintergrundbild ändern</translation>
    </message>
    <message>
        <source>The current image is now the background image of %1. It was saved as %2.</source>
        <translation>Das aktuelle Bild ist jetzt das Hintergrundbild von %1. Es wurde als %2 gespeichert.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackwardTracker</name>
    <message>
        <source>Correct position</source>
        <translation>Position korrigieren</translation>
    </message>
    <message>
        <source>The target was tracked backward to frame %1. It is now being tracked forward again from this frame.</source>
        <translation>Das Ziel wurde rückwärts bis Bild %1 verfolgt. Ab diesem Bild wird es jetzt wieder vorwärts verfolgt.</translation>
    </message>
    <message>
        <source>Tracking the target backward: frame %1.</source>
        <translation>Das Ziel wird rückwärts verfolgt: Bild %1.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BirdsEyeView</name>
    <message>
        <source>Bird&apos;s-eye view</source>
        <translation>Vogelperspektive</translation>
    </message>
    <message>
        <source>The room in 3D: cameras, particles, estimates and their tracks</source>
        <translation>Der Raum in 3D: Kameras, Partikel, Schätzungen und ihre Spuren</translation>
    </message>
    <message>
        <source>3D view not available: %1</source>
        <translation>3D-Ansicht nicht verfügbar: %1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrationPage</name>
    <message>
        <source>Board</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>Values to calibrate</source>
        <translation>Zu bestimmende Werte</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Find the board in the recording and calibrate the cameras with it (one undo step)</source>
        <translation>Die Tafel in der Aufnahme suchen und die Kameras damit kalibrieren (ein Schritt zum Rückgängigmachen)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop and keep the previous calibration</source>
        <translation>Abbrechen und die bisherige Kalibrierung behalten</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Use the calibration in the project (one undo step)</source>
        <translation>Die Kalibrierung im Projekt verwenden (ein Schritt zum Rückgängigmachen)</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Save a page with the residuals, coverage and errors of all images, and open it</source>
        <translation>Eine Seite mit Residuen, Abdeckung und Fehlern aller Bilder speichern und öffnen</translation>
    </message>
    <message>
        <source>Calibration progress</source>
        <translation>Fortschritt der Kalibrierung</translation>
    </message>
    <message>
        <source>Show a printed board to the cameras. This page says what to show next. A view is captured when you hold the board still.</source>
        <translation>Zeigen Sie den Kameras eine gedruckte Tafel. Diese Seite sagt, was als Nächstes zu zeigen ist. Eine Ansicht wird aufgenommen, wenn Sie die Tafel still halten.</translation>
    </message>
    <message>
        <source>To calibrate from a recording, record a printed board that you hold still in many positions, some of them close to the camera or tilted.</source>
        <translation>Um aus einer Aufnahme zu kalibrieren, nehmen Sie eine gedruckte Tafel auf, die Sie in vielen Positionen still halten, in einigen nah an der Kamera oder geneigt.</translation>
    </message>
    <message>
        <source>Live cameras</source>
        <translation>Livekameras</translation>
    </message>
    <message>
        <source>This recording</source>
        <translation>Diese Aufnahme</translation>
    </message>
    <message>
        <source>✓ The cameras are calibrated (Ctrl+Z undoes this).</source>
        <translation>✓ Die Kameras sind kalibriert (Strg+Z macht es rückgängig).</translation>
    </message>
    <message>
        <source>Looking for the board: %p %</source>
        <translation>Suche die Tafel: %p %</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Page (*.html)</source>
        <translation>Seite (*.html)</translation>
    </message>
    <message>
        <source>Use calibration anyway</source>
        <translation>Kalibrierung trotzdem verwenden</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Find board</source>
        <translation>Tafel suchen</translation>
    </message>
    <message>
        <source>Use this board</source>
        <translation>Diese Tafel verwenden</translation>
    </message>
    <message>
        <source>Search all frames</source>
        <translation>Alle Bilder durchsuchen</translation>
    </message>
    <message>
        <source>Find out from the images which kind of board they show, how many squares it has, and its dictionary. The images do not show how large the squares are: measure this yourself</source>
        <translation>Aus den Bildern bestimmen, welche Art von Tafel sie zeigen, wie viele Felder sie hat und welches Wörterbuch. Wie groß die Felder sind, zeigen die Bilder nicht: Messen Sie es selbst</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Berechne</translation>
    </message>
    <message>
        <source>%1 of the %2 searched images show the board that you described.</source>
        <translation>%1 der %2 durchsuchten Bilder zeigen die Tafel, die Sie beschrieben haben.</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Bilder spiegeln</translation>
    </message>
    <message>
        <source>Saved %1: the board is larger than the paper. Page 1 shows how to put its %2 sheets together.</source>
        <translation>%1 gespeichert: Die Tafel ist größer als das Papier. Seite 1 zeigt, wie die %2 Blätter zusammengesetzt werden.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrator</name>
    <message>
        <source>Stopped. The previous calibration is kept.</source>
        <translation>Abgebrochen. Die bisherige Kalibrierung bleibt.</translation>
    </message>
    <message>
        <source>The cameras of the project have changed: calibrate again.</source>
        <translation>Die Kameras des Projekts haben sich geändert: Bitte neu kalibrieren.</translation>
    </message>
    <message>
        <source>Calibrate with a board</source>
        <translation>Mit einer Tafel kalibrieren</translation>
    </message>
    <message>
        <source>No board was found. Show the whole board in focus and in even light, then press Find board again.</source>
        <translation>Keine Tafel gefunden. Zeigen Sie die ganze Tafel scharf und in gleichmäßigem Licht, und drücken Sie noch einmal Tafel suchen.</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Bilder spiegeln</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardFloor</name>
    <message>
        <source>Looking for the board in the images shown…</source>
        <translation>Die Tafel wird in den gezeigten Bildern gesucht…</translation>
    </message>
    <message>
        <source>No camera sees the board well enough: %1. Show images in which the board lies on the floor, or correct the description of the board on the page Board.</source>
        <translation>Keine Kamera sieht die Tafel gut genug: %1. Zeigen Sie Bilder, in denen die Tafel auf dem Boden liegt, oder berichtigen Sie die Beschreibung der Tafel auf der Seite Tafel.</translation>
    </message>
    <message>
        <source>The floor was not set, because the cameras have changed in the meantime. Try again.</source>
        <translation>Der Boden wurde nicht gesetzt, weil die Kameras inzwischen geändert wurden. Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Set the floor from the board</source>
        <translation>Boden aus der Tafel setzen</translation>
    </message>
    <message numerus="yes">
        <source>The floor is set from the board, which %n camera(s) can see (error %1). The world was rotated by %2.</source>
        <translation>
            <numerusform>Der Boden ist aus der Tafel gesetzt, die %n Kamera sieht (Fehler %1). Die Welt wurde um %2 gedreht.</numerusform>
            <numerusform>Der Boden ist aus der Tafel gesetzt, die %n Kameras sehen (Fehler %1). Die Welt wurde um %2 gedreht.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardForm</name>
    <message>
        <source>Print the board</source>
        <translation>Tafel drucken</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>ChArUco (with markers)</source>
        <translation>ChArUco (mit Markern)</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>Art der Tafel</translation>
    </message>
    <message>
        <source>Squares per row and column</source>
        <translation>Felder je Zeile und Spalte</translation>
    </message>
    <message>
        <source>Squares in a row</source>
        <translation>Felder in einer Zeile</translation>
    </message>
    <message>
        <source>Number of squares in a row, black and white together</source>
        <translation>Zahl der Felder in einer Zeile, schwarze und weiße zusammen</translation>
    </message>
    <message>
        <source>Squares in a column</source>
        <translation>Felder in einer Spalte</translation>
    </message>
    <message>
        <source>Number of squares in a column, black and white together</source>
        <translation>Zahl der Felder in einer Spalte, schwarze und weiße zusammen</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Seite eines Feldes</translation>
    </message>
    <message>
        <source>Unit of the sizes</source>
        <translation>Einheit der Größen</translation>
    </message>
    <message>
        <source>Unit of the sizes that you enter</source>
        <translation>Einheit der Größen, die Sie eingeben</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>Seite eines Markers</translation>
    </message>
    <message>
        <source>Dictionary of the markers</source>
        <translation>Wörterbuch der Marker</translation>
    </message>
    <message>
        <source>The marker dictionary that was chosen when the board was made</source>
        <translation>Das Wörterbuch der Marker, das beim Erstellen der Tafel gewählt wurde</translation>
    </message>
    <message>
        <source>Legacy ChArUco layout</source>
        <translation>Altes ChArUco-Layout</translation>
    </message>
    <message>
        <source>Inverted colors</source>
        <translation>Farben umgekehrt</translation>
    </message>
    <message>
        <source>White markers and corners on a black page</source>
        <translation>Weiße Marker und Ecken auf schwarzem Blatt</translation>
    </message>
    <message>
        <source>Print this board…</source>
        <translation>Diese Tafel drucken…</translation>
    </message>
    <message>
        <source>Save the board as a PDF at its true size, with a scale bar to check with a ruler</source>
        <translation>Die Tafel in wahrer Größe als PDF speichern, mit einem Maßstab zum Nachmessen</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>%1 × %2 inner corners. Description for the command line:</source>
        <translation>%1 × %2 innere Ecken. Beschreibung für die Befehlszeile:</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>Wörterbuch</translation>
    </message>
    <message>
        <source>A ChArUco board may be partly hidden, or partly outside the image; a chessboard must be completely visible</source>
        <translation>Eine ChArUco-Tafel darf teilweise verdeckt sein oder teilweise außerhalb des Bildes liegen; ein Schachbrett muss ganz zu sehen sein</translation>
    </message>
    <message>
        <source>Measure a long row on the print with a ruler, and divide its length by the number of its squares</source>
        <translation>Messen Sie eine lange Zeile am Ausdruck mit dem Lineal, und teilen Sie ihre Länge durch die Zahl ihrer Felder</translation>
    </message>
    <message>
        <source>Length of one side of a marker, with its black border</source>
        <translation>Länge einer Seite eines Markers, mit seinem schwarzen Rand</translation>
    </message>
    <message>
        <source>For ChArUco boards with an even number of rows that were made with software older than OpenCV 4.6: their first square is white</source>
        <translation>Für ChArUco-Tafeln mit gerader Zeilenzahl, die mit Software vor OpenCV 4.6 hergestellt wurden: Ihr erstes Feld ist weiß</translation>
    </message>
    <message>
        <source>Size of the paper. A larger board is split over several sheets</source>
        <translation>Größe des Papiers. Eine größere Tafel wird auf mehrere Blätter verteilt</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardGoalForm</name>
    <message>
        <source>Find</source>
        <translation>Gesucht</translation>
    </message>
    <message>
        <source>Intrinsics and positions</source>
        <translation>Intrinsik und Positionen</translation>
    </message>
    <message>
        <source>Intrinsics</source>
        <translation>Intrinsische Parameter</translation>
    </message>
    <message>
        <source>Camera positions</source>
        <translation>Kamerapositionen</translation>
    </message>
    <message>
        <source>Values to calibrate</source>
        <translation>Zu bestimmende Werte</translation>
    </message>
    <message>
        <source>Intrinsics: lens and sensor, for each camera separately. Positions: where the cameras are, computed from a board that several cameras see at the same time</source>
        <translation>Intrinsik: Objektiv und Sensor, für jede Kamera einzeln. Positionen: wo die Kameras stehen, berechnet aus einer Tafel, die mehrere Kameras zugleich sehen</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>Objektivmodell</translation>
    </message>
    <message>
        <source>Pinhole, 5 coefficients</source>
        <translation>Lochkamera, 5 Koeffizienten</translation>
    </message>
    <message>
        <source>Pinhole, 8 coefficients (wide)</source>
        <translation>Lochkamera, 8 Koeffizienten (Weitwinkel)</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>Fischauge</translation>
    </message>
    <message>
        <source>Frame with the board on the floor</source>
        <translation>Bild mit der Tafel auf dem Boden</translation>
    </message>
    <message>
        <source>Number of the frame with the board on the floor</source>
        <translation>Bild, in dem die Tafel auf dem Boden liegt</translation>
    </message>
    <message>
        <source>Set to current frame</source>
        <translation>Aktuelles Bild</translation>
    </message>
    <message>
        <source>Set floor frame to current frame</source>
        <translation>Aktuelles Bild für den Boden verwenden</translation>
    </message>
    <message>
        <source>Enter the number of the frame that is shown now</source>
        <translation>Die Nummer des jetzt gezeigten Bildes eintragen</translation>
    </message>
    <message>
        <source>Accuracy goal</source>
        <translation>Gewünschte Genauigkeit</translation>
    </message>
    <message>
        <source>Desired accuracy of the intrinsics</source>
        <translation>Gewünschte Genauigkeit der intrinsischen Parameter</translation>
    </message>
    <message>
        <source>Guidance ends when the intrinsics are this accurate in all parts of the image</source>
        <translation>Die Anleitung endet, wenn die intrinsischen Parameter überall im Bild so genau sind</translation>
    </message>
    <message>
        <source>Desired accuracy of the positions</source>
        <translation>Gewünschte Genauigkeit der Positionen</translation>
    </message>
    <message>
        <source>Guidance ends when the position of each camera is this accurate</source>
        <translation>Die Anleitung endet, wenn die Position jeder Kamera so genau ist</translation>
    </message>
    <message>
        <source>5 coefficients for most lenses, 8 for wide-angle lenses, fisheye for a field of view above about 120°</source>
        <translation>5 Koeffizienten für die meisten Objektive, 8 für weitwinklige, Fischauge für einen Bildwinkel über etwa 120°</translation>
    </message>
    <message>
        <source>The board as it lies in this video frame defines the world coordinates: X along its rows, Y toward its upper edge, Z up from the floor. Without such a frame, the first camera keeps its position</source>
        <translation>Die Tafel, wie sie in diesem Bild des Videos liegt, legt die Weltkoordinaten fest: X entlang ihrer Zeilen, Y zu ihrer Oberkante, Z vom Boden nach oben. Ohne ein solches Bild behält die erste Kamera ihre Position</translation>
    </message>
    <message>
        <source>Number of the frame, as in the timeline (the first frame is 1)</source>
        <translation>Nummer des Einzelbilds wie in der Zeitleiste (das erste ist 1)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardLive</name>
    <message>
        <source>Time for which the board was held still in front of %1</source>
        <translation>Zeit, für die die Tafel vor %1 still gehalten wurde</translation>
    </message>
    <message>
        <source>Positions in which %1 saw the board</source>
        <translation>Positionen, in denen %1 die Tafel sah</translation>
    </message>
    <message>
        <source>Filled: image regions and tilts in which the board was already shown. Orange: what to show next. Green: the board in the current image</source>
        <translation>Gefüllt: Bereiche und Neigungen, in denen die Tafel gezeigt wurde. Orange: was als Nächstes zu zeigen ist. Grün: die Tafel im aktuellen Bild</translation>
    </message>
    <message>
        <source>Capture now</source>
        <translation>Jetzt aufnehmen</translation>
    </message>
    <message>
        <source>Capture the board as it is shown now, even if it is not held still</source>
        <translation>Die Tafel aufnehmen, wie sie jetzt gezeigt wird, auch wenn sie nicht still gehalten wird</translation>
    </message>
    <message>
        <source>Set floor from board</source>
        <translation>Boden aus Tafel setzen</translation>
    </message>
    <message>
        <source>Next: positions</source>
        <translation>Weiter: Positionen</translation>
    </message>
    <message>
        <source>Accept the current accuracy of the intrinsics; then show the board to several cameras at once</source>
        <translation>Die jetzige Genauigkeit der intrinsischen Parameter annehmen, dann die Tafel mehreren Kameras zugleich zeigen</translation>
    </message>
    <message>
        <source>Calibrate with these views</source>
        <translation>Mit diesen Ansichten kalibrieren</translation>
    </message>
    <message>
        <source>Finish now with the views captured so far</source>
        <translation>Jetzt mit den bisher aufgenommenen Ansichten abschließen</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Find the board in the live images and get guidance on what to show</source>
        <translation>Die Tafel in den Livebildern suchen und Hinweise erhalten, was zu zeigen ist</translation>
    </message>
    <message>
        <source>Waiting for images. Check that the cameras are running.</source>
        <translation>Warte auf Bilder. Prüfen Sie, ob die Kameras laufen.</translation>
    </message>
    <message>
        <source>Show the board to one camera after the other, following the instructions for each.</source>
        <translation>Zeigen Sie die Tafel einer Kamera nach der anderen, nach der Anleitung zu jeder.</translation>
    </message>
    <message>
        <source>Large display…</source>
        <translation>Große Anzeige…</translation>
    </message>
    <message>
        <source>Show what to do next in large letters that can be read from across the room, with a sound for each captured view</source>
        <translation>In großen, quer durch den Raum lesbaren Buchstaben zeigen, was als Nächstes zu tun ist, mit einem Ton für jede aufgenommene Ansicht</translation>
    </message>
    <message>
        <source>Define the world coordinates with the board that lies on the floor now: X along its rows, Y toward its upper edge, Z up from the floor</source>
        <translation>Die Weltkoordinaten mit der Tafel festlegen, die jetzt auf dem Boden liegt: X entlang ihrer Zeilen, Y zu ihrer Oberkante, Z vom Boden nach oben</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxExportDialog</name>
    <message>
        <source>Export boxes</source>
        <translation>Rahmen exportieren</translation>
    </message>
    <message>
        <source>First lines of boxes.csv</source>
        <translation>Erste Zeilen von boxes.csv</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Folder for both files; it is created if it does not exist</source>
        <translation>Beide Dateien werden in diesem Ordner gespeichert; er wird angelegt, wenn es ihn nicht gibt</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder of the files</source>
        <translation>Den Ordner der Dateien wählen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write both files (Enter)</source>
        <translation>Beide Dateien schreiben (Eingabetaste)</translation>
    </message>
    <message>
        <source>Folder of the boxes</source>
        <translation>Ordner der Rahmen</translation>
    </message>
    <message>
        <source>Saved boxes.csv and boxes_mot.txt in %1.</source>
        <translation>boxes.csv und boxes_mot.txt wurden in %1 gespeichert.</translation>
    </message>
    <message>
        <source>The folder already contains exported boxes. Replace them?</source>
        <translation>Der Ordner enthält schon exportierte Rahmen. Ersetzen?</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 gibt es schon; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Two files are written. In boxes.csv, each row has the box of one target in one frame, its center, its similarity, and whether the target was seen or hidden. The file boxes_mot.txt has the format of the MOT challenge. All lengths are in pixels.</source>
        <translation>Zwei Dateien werden geschrieben. In boxes.csv enthält jede Zeile den Rahmen eines Ziels in einem Bild, seine Mitte, seine Ähnlichkeit und ob das Ziel gesehen oder verdeckt war. Die Datei boxes_mot.txt hat das Format der MOT Challenge. Alle Längen sind in Pixeln.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxModel</name>
    <message>
        <source>◌ hidden</source>
        <translation>◌ verdeckt</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Time of the frame, in seconds</source>
        <translation>Zeit des Bildes, in Sekunden</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>Bild, ab 1 gezählt</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>Name des Ziels</translation>
    </message>
    <message>
        <source>x, px</source>
        <translation>x, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the left edge of the image</source>
        <translation>Mitte des Rahmens, Pixel vom linken Bildrand</translation>
    </message>
    <message>
        <source>y, px</source>
        <translation>y, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the upper edge of the image</source>
        <translation>Mitte des Rahmens, Pixel vom oberen Bildrand</translation>
    </message>
    <message>
        <source>width, px</source>
        <translation>Breite, px</translation>
    </message>
    <message>
        <source>Box width (pixels)</source>
        <translation>Breite des Rahmens, Pixel</translation>
    </message>
    <message>
        <source>height, px</source>
        <translation>Höhe, px</translation>
    </message>
    <message>
        <source>Box height (pixels)</source>
        <translation>Höhe des Rahmens, Pixel</translation>
    </message>
    <message>
        <source>similarity</source>
        <translation>Ähnlichkeit</translation>
    </message>
    <message>
        <source>Similarity of the colors in the box to the initial colors, 0 to 1</source>
        <translation>Ähnlichkeit der Farben im Rahmen mit den anfänglichen Farben, 0 bis 1</translation>
    </message>
    <message>
        <source>spread, px</source>
        <translation>Streuung, px</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Hidden: the target was not found in this frame; the box shows where it is expected</source>
        <translation>Verdeckt: Das Ziel wurde in diesem Bild nicht gefunden; der Rahmen zeigt, wo es erwartet wird</translation>
    </message>
    <message>
        <source>● tracking</source>
        <translation>● verfolgt</translation>
    </message>
    <message>
        <source>Root mean square distance of the particles from their mean</source>
        <translation>Mittlerer quadratischer Abstand (RMS) der Partikel von ihrem Mittel</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPanel</name>
    <message>
        <source>Boxes of the targets</source>
        <translation>Rahmen der Ziele</translation>
    </message>
    <message>
        <source>This method tracks boxes in images. Click the object or drag a box around it in any camera view. Its box in each frame appears here, in pixels.</source>
        <translation>Dieses Verfahren verfolgt Rahmen in Bildern. Klicken Sie das Objekt in einer Kameraansicht an, oder ziehen Sie einen Rahmen darum. Hier erscheint sein Rahmen in jedem Bild, in Pixeln.</translation>
    </message>
    <message numerus="yes">
        <source>%n boxes (coordinates in image pixels)</source>
        <translation>
            <numerusform>%n Rahmen (Koordinaten in Bildpixeln)</numerusform>
            <numerusform>%n Rahmen (Koordinaten in Bildpixeln)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPicker</name>
    <message>
        <source>No box can be set here, because this camera shows no image.</source>
        <translation>Hier lässt sich kein Rahmen setzen, weil diese Kamera kein Bild zeigt.</translation>
    </message>
    <message>
        <source>Box of %1</source>
        <translation>Rahmen von %1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationChoice</name>
    <message>
        <source>Calibration file:</source>
        <translation>Kalibrierungsdatei:</translation>
    </message>
    <message>
        <source>A calibration file of Dewpoint or another program. Cameras are matched by name, or by order if the names differ</source>
        <translation>Eine Kalibrierungsdatei von Dewpoint oder einem anderen Programm. Kameras werden nach Namen zugeordnet, oder nach Reihenfolge, wenn die Namen nicht passen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Continue without a calibration file</source>
        <translation>Ohne Kalibrierungsdatei fortfahren</translation>
    </message>
    <message>
        <source>Recognized: %1. The file does not contain everything: %2. Create the project without this file, then choose Calibration › Import calibration and enter what is missing.</source>
        <translation>Erkannt: %1. Die Datei enthält nicht alles: %2. Erstellen Sie das Projekt ohne diese Datei, wählen Sie dann Kalibrierung › Kalibrierung importieren, und geben Sie das Fehlende ein.</translation>
    </message>
    <message>
        <source>Recognized: %1. It cannot be used: %2.</source>
        <translation>Erkannt: %1. Sie lässt sich nicht verwenden: %2.</translation>
    </message>
    <message>
        <source>The file cannot be used: %1.</source>
        <translation>Die Datei lässt sich nicht verwenden: %1.</translation>
    </message>
    <message>
        <source>Not recognized. Dewpoint reads: %1.</source>
        <translation>Nicht erkannt. Dewpoint liest: %1.</translation>
    </message>
    <message>
        <source>Recognized: %1. The cameras in the file do not match the cameras above: %2.</source>
        <translation>Erkannt: %1. Die Kameras in der Datei passen nicht zu den Kameras oben: %2.</translation>
    </message>
    <message numerus="yes">
        <source>✓ Recognized: %1, %n cameras</source>
        <translation>
            <numerusform>✓ Erkannt: %1, %n Kamera</numerusform>
            <numerusform>✓ Erkannt: %1, %n Kameras</numerusform>
        </translation>
    </message>
    <message>
        <source>None: the camera positions will only be guesses</source>
        <translation>Keine: Die Kamerapositionen werden nur geraten</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Kalibrierung importieren…</translation>
    </message>
    <message>
        <source>Import a calibration</source>
        <translation>Eine Kalibrierung importieren</translation>
    </message>
    <message>
        <source>%1 (found beside the recordings)</source>
        <translation>%1 (bei den Aufnahmen gefunden)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationDock</name>
    <message>
        <source>Pages of the camera calibration</source>
        <translation>Seiten der Kamerakalibrierung</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationExportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Export the calibration</source>
        <translation>Kalibrierung exportieren</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write the file; an existing file is replaced</source>
        <translation>Die Datei schreiben; eine vorhandene wird ersetzt</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>The program that will read the file</source>
        <translation>Das Programm, das die Datei lesen soll</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Unit of lengths, if the format does not define it</source>
        <translation>Einheit der Längen, wenn das Format sie nicht festlegt</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>%1 exists and will be replaced.</source>
        <translation>%1 gibt es schon und wird ersetzt.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>%1: with the exported calibration, projected points move by at most %2, because the format cannot store this lens model and the lens was fitted again</source>
        <translation>%1: mit der exportierten Kalibrierung verschieben sich projizierte Punkte um höchstens %2, weil das Format dieses Objektivmodell nicht speichern kann und das Objektiv neu angepasst wurde</translation>
    </message>
    <message>
        <source>%1: with the exported calibration, projected points move by at most %2</source>
        <translation>%1: mit der exportierten Kalibrierung verschieben sich projizierte Punkte um höchstens %2</translation>
    </message>
    <message>
        <source>%1: with the exported lens, %2 of 81 tested directions can no longer be projected into the image</source>
        <translation>%1: mit dem exportierten Objektiv lassen sich %2 von 81 geprüften Richtungen nicht mehr ins Bild projizieren</translation>
    </message>
    <message>
        <source>default of the format</source>
        <translation>Voreinstellung des Formats</translation>
    </message>
    <message>
        <source>No accuracy is lost: points are projected to the same pixels as before.</source>
        <translation>Es geht keine Genauigkeit verloren: Punkte werden auf dieselben Pixel projiziert wie vorher.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationFit</name>
    <message>
        <source>Change since the calibration:</source>
        <translation>Änderung seit der Kalibrierung:</translation>
    </message>
    <message>
        <source>How the images differ from those of the calibration, if they have another size</source>
        <translation>Wie sich die Bilder von denen der Kalibrierung unterscheiden, wenn sie eine andere Größe haben</translation>
    </message>
    <message>
        <source>Change of the images since the calibration</source>
        <translation>Änderung der Bilder seit der Kalibrierung</translation>
    </message>
    <message>
        <source>For each camera of the project, choose a camera of the file:</source>
        <translation>Wählen Sie für jede Kamera des Projekts eine Kamera der Datei:</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationImportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>Import a calibration</source>
        <translation>Eine Kalibrierung importieren</translation>
    </message>
    <message>
        <source>match by name</source>
        <translation>nach Namen zuordnen</translation>
    </message>
    <message>
        <source>import only for %1</source>
        <translation>nur für %1 importieren</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>Choose a folder with one file per camera</source>
        <translation>Einen Ordner mit einer Datei je Kamera wählen</translation>
    </message>
    <message>
        <source>Use the calibration in the project; you can undo this</source>
        <translation>Die Kalibrierung im Projekt verwenden; das lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>as in the file</source>
        <translation>wie in der Datei</translation>
    </message>
    <message>
        <source>detect automatically</source>
        <translation>automatisch erkennen</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>k1 k2 p1 p2 (pinhole)</source>
        <translation>k1 k2 p1 p2 (Lochkamera)</translation>
    </message>
    <message>
        <source>k1 k2 k3 k4 (fisheye)</source>
        <translation>k1 k2 k3 k4 (Fischauge)</translation>
    </message>
    <message>
        <source>from world to camera</source>
        <translation>von der Welt zur Kamera</translation>
    </message>
    <message>
        <source>from camera to world</source>
        <translation>von der Kamera zur Welt</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>The program that wrote the file</source>
        <translation>Das Programm, das die Datei geschrieben hat</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Unit of the lengths in the file; or enter the length of one unit in meters, such as 0.025 for squares of 25 mm</source>
        <translation>Einheit der Längen in der Datei; oder geben Sie die Länge einer Einheit in Metern ein, etwa 0.025 für Felder von 25 mm</translation>
    </message>
    <message>
        <source>Meaning of the four lens coefficients</source>
        <translation>Bedeutung der vier Objektivkoeffizienten</translation>
    </message>
    <message>
        <source>Image size</source>
        <translation>Bildgröße</translation>
    </message>
    <message>
        <source>Width and height in pixels, such as 1280x720</source>
        <translation>Breite und Höhe in Pixeln, etwa 1280x720</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Direction of the transformation that the file stores as a pose</source>
        <translation>Richtung der Transformation, die die Datei als Lage speichert</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Project camera that gets the calibration, if the file contains only one camera</source>
        <translation>Kamera des Projekts, die die Kalibrierung erhält, wenn die Datei nur eine Kamera enthält</translation>
    </message>
    <message>
        <source>The file lacks a required value. Set “%1” above.</source>
        <translation>In der Datei fehlt ein nötiger Wert. Stellen Sie oben „%1“ ein.</translation>
    </message>
    <message>
        <source>The calibration uses other camera names. The cameras were matched by order.</source>
        <translation>Die Kalibrierung verwendet andere Kameranamen. Die Kameras wurden nach Reihenfolge zugeordnet.</translation>
    </message>
    <message>
        <source>%1 (in the file: %2): moves by %3 and rotates by %4</source>
        <translation>%1 (in der Datei: %2): verschiebt sich um %3 und dreht sich um %4</translation>
    </message>
    <message>
        <source>Import calibration</source>
        <translation>Kalibrierung importieren</translation>
    </message>
    <message>
        <source>The cameras now use the calibration from %1.</source>
        <translation>Die Kameras verwenden jetzt die Kalibrierung aus %1.</translation>
    </message>
    <message>
        <source>match automatically</source>
        <translation>automatisch zuordnen</translation>
    </message>
    <message>
        <source>Project images</source>
        <translation>Bilder des Projekts</translation>
    </message>
    <message>
        <source>Names in the file</source>
        <translation>Namen in der Datei</translation>
    </message>
    <message>
        <source>The calibration does not fit the project. Set “%1” above.</source>
        <translation>Die Kalibrierung passt nicht zum Projekt. Stellen Sie oben „%1“ ein.</translation>
    </message>
    <message>
        <source>Probably a mistake: %1</source>
        <translation>Wahrscheinlich ein Fehler: %1</translation>
    </message>
    <message>
        <source>For each camera of the project, choose the camera in the file from which it gets its calibration</source>
        <translation>Wählen Sie für jede Kamera des Projekts die Kamera in der Datei, von der sie ihre Kalibrierung erhält</translation>
    </message>
    <message>
        <source>How the images of the project differ from those of the calibration, if they have another size</source>
        <translation>Wie sich die Bilder des Projekts von denen der Kalibrierung unterscheiden, wenn sie eine andere Größe haben</translation>
    </message>
    <message>
        <source>The file contains no pose. Only the intrinsics are imported; the camera keeps its current pose.</source>
        <translation>Die Datei enthält keine Lage. Nur die Intrinsik wird importiert; die Kamera behält ihre jetzige Lage.</translation>
    </message>
    <message>
        <source>After the import, projected points are at most %1 away from where the file projects them</source>
        <translation>Nach dem Import liegen projizierte Punkte höchstens %1 von der Stelle entfernt, an die die Datei sie projiziert</translation>
    </message>
    <message>
        <source>Apply calibration</source>
        <translation>Kalibrierung anwenden</translation>
    </message>
    <message>
        <source>default of the format</source>
        <translation>Voreinstellung des Formats</translation>
    </message>
    <message>
        <source>Lens model (4 coefficients)</source>
        <translation>Linsenmodell (4 Koeffizienten)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationMode</name>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraAgreementAlerts</name>
    <message>
        <source>Calibrate %1…</source>
        <translation>%1 kalibrieren…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraEdits</name>
    <message numerus="yes">
        <source>Add %n camera(s)</source>
        <translation>
            <numerusform>%n Kamera hinzufügen</numerusform>
            <numerusform>%n Kameras hinzufügen</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove camera</source>
        <translation>Kamera entfernen</translation>
    </message>
    <message>
        <source>Replace camera</source>
        <translation>Kamera ersetzen</translation>
    </message>
    <message>
        <source>Exchange cameras</source>
        <translation>Kameras vertauschen</translation>
    </message>
    <message>
        <source>Rename camera</source>
        <translation>Kamera umbenennen</translation>
    </message>
    <message>
        <source>Rotate images</source>
        <translation>Bilder drehen</translation>
    </message>
    <message>
        <source>Change image format</source>
        <translation>Bildformat ändern</translation>
    </message>
    <message>
        <source>Change camera setting</source>
        <translation>Kameraeinstellung ändern</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>Farben sperren</translation>
    </message>
    <message>
        <source>Crop images</source>
        <translation>Bilder zuschneiden</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraForm</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>The camera to adjust; you can also click its image</source>
        <translation>Die Kamera, die eingestellt wird; Sie können auch ihr Bild anklicken</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Unit of positions</source>
        <translation>Einheit der Positionen</translation>
    </message>
    <message>
        <source>Unit for showing and entering positions</source>
        <translation>Einheit zum Anzeigen und Eingeben von Positionen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <source>point, roll</source>
        <translation>Punkt, Rollen</translation>
    </message>
    <message>
        <source>yaw, pitch, roll</source>
        <translation>Gieren, Nicken, Rollen</translation>
    </message>
    <message>
        <source>Direction format</source>
        <translation>Format der Blickrichtung</translation>
    </message>
    <message>
        <source>Enter the direction as a point that the camera looks at, or as angles: yaw is measured from x toward y, pitch above the horizon, and roll about the line of sight</source>
        <translation>Geben Sie die Richtung als Punkt ein, auf den die Kamera blickt, oder als Winkel: Gier von x nach y, Nick über dem Horizont, Roll um die Blickrichtung</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>focal length</source>
        <translation>Brennweite</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>Lens parameter</source>
        <translation>Objektivparameter</translation>
    </message>
    <message>
        <source>Focal length in pixels, or the horizontal field of view in degrees</source>
        <translation>Brennweite in Pixeln oder waagerechter Bildwinkel in Grad</translation>
    </message>
    <message>
        <source>Focal length or field of view</source>
        <translation>Brennweite oder Bildwinkel</translation>
    </message>
    <message>
        <source>Magnification of the camera; the keys + and − also change it</source>
        <translation>Vergrößerung der Kamera; auch die Tasten + und − ändern sie</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>turns the camera</source>
        <translation>dreht die Kamera</translation>
    </message>
    <message>
        <source>slides the camera</source>
        <translation>verschiebt die Kamera</translation>
    </message>
    <message>
        <source>Effect of dragging</source>
        <translation>Wirkung des Ziehens</translation>
    </message>
    <message>
        <source>What the camera does while you drag the grid and no point is held. Click points of the grid to hold up to three of them.</source>
        <translation>Was die Kamera tut, während Sie das Gitter ziehen und kein Punkt gehalten wird. Klicks auf Punkte des Gitters halten bis zu drei davon fest.</translation>
    </message>
    <message>
        <source>Also fit the focal length when three points are held</source>
        <translation>Bei drei gehaltenen Punkten die Brennweite anpassen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>move</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>What the keys do to the camera</source>
        <translation>Was die Tasten mit der Kamera tun</translation>
    </message>
    <message>
        <source>camera axes</source>
        <translation>Kameraachsen</translation>
    </message>
    <message>
        <source>world axes</source>
        <translation>Weltachsen</translation>
    </message>
    <message>
        <source>Axes along which the keys move the camera</source>
        <translation>Achsen, entlang denen die Tasten die Kamera bewegen</translation>
    </message>
    <message>
        <source>Move along the camera&apos;s right, forward and up directions, or along the world axes</source>
        <translation>Entlang rechts, vorwärts und aufwärts der Kamera bewegen, oder entlang der Weltachsen</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Position %1</translation>
    </message>
    <message>
        <source>%1 coordinate of the camera&apos;s position</source>
        <translation>%1-Koordinate der Kameraposition</translation>
    </message>
    <message>
        <source>Looks at (%1 coordinate)</source>
        <translation>Blickt auf (%1-Koordinate)</translation>
    </message>
    <message>
        <source>%1 coordinate of the point that the camera looks at</source>
        <translation>%1-Koordinate des Punktes, auf den die Kamera blickt</translation>
    </message>
    <message>
        <source>Direction seen from above: 0° along x, 90° along y</source>
        <translation>Richtung, von oben gesehen: 0° entlang x, 90° entlang y</translation>
    </message>
    <message>
        <source>Angle above the horizon; straight down is −90°</source>
        <translation>Winkel über dem Horizont; senkrecht nach unten ist −90°</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Clockwise rotation about the line of sight</source>
        <translation>Drehung um die Blickrichtung, im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>looks at</source>
        <translation>blickt auf</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Three held points fix the pose. With this option, dragging changes the focal length, and the pose is adapted so that the three points stay in place</source>
        <translation>Drei gehaltene Punkte legen die Lage fest. Mit dieser Option ändert Ziehen die Brennweite, und die Lage wird so angepasst, dass die drei Punkte an ihrem Ort bleiben</translation>
    </message>
    <message>
        <source>The arrow keys, the page keys and W, A, S, D, Q and E move or turn the camera by 1 cm or 0.2° a step. With Shift, the steps are ten times as large. With Ctrl, the steps of the arrow and page keys are a tenth as large.</source>
        <translation>Die Pfeiltasten, die Bildtasten und W, A, S, D, Q und E bewegen oder drehen die Kamera um 1 cm oder 0,2° je Schritt. Mit Umschalt sind die Schritte zehnmal so groß. Mit Strg sind die Schritte der Pfeil- und Bildtasten ein Zehntel so groß.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraMotionAlerts</name>
    <message>
        <source>%1 was rotated by %2 (frame %3).</source>
        <translation>%1 wurde um %2 gedreht (Bild %3).</translation>
    </message>
    <message>
        <source>The new pose of this camera is being computed.</source>
        <translation>Die neue Lage dieser Kamera wird gerade berechnet.</translation>
    </message>
    <message>
        <source>The pose of this camera can be recomputed from its images.</source>
        <translation>Die Lage dieser Kamera lässt sich aus ihren Bildern neu berechnen.</translation>
    </message>
    <message>
        <source>Recompute pose of %1</source>
        <translation>Lage von %1 neu berechnen</translation>
    </message>
    <message>
        <source>The pose of this camera cannot be recomputed from its images: calibrate the camera again, or move it back.</source>
        <translation>Die Lage dieser Kamera lässt sich aus ihren Bildern nicht neu berechnen: Kalibrieren Sie die Kamera neu, oder stellen Sie sie zurück.</translation>
    </message>
    <message>
        <source>Calibrate %1…</source>
        <translation>%1 kalibrieren…</translation>
    </message>
    <message>
        <source>%1 is back in its calibrated pose.</source>
        <translation>%1 ist wieder in ihrer kalibrierten Lage.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraPanel</name>
    <message>
        <source>Rename camera</source>
        <translation>Kamera umbenennen</translation>
    </message>
    <message>
        <source>Change image source</source>
        <translation>Bildquelle ändern</translation>
    </message>
    <message>
        <source>Rotate images</source>
        <translation>Bilder drehen</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the camera, in views and files</source>
        <translation>Name der Kamera, in Ansichten und Dateien</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Video file, image folder, device, or stream address</source>
        <translation>Videodatei, Ordner mit Bildern, Gerät oder Adresse eines Stroms</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the file, folder or device of this camera</source>
        <translation>Datei, Ordner oder Gerät dieser Kamera wählen</translation>
    </message>
    <message>
        <source>Rotated</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, focal length %3 pixels
Position x, y, z: %4, %5, %6</source>
        <translation>%1 × %2 Pixel, Brennweite %3 Pixel
Position x, y, z: %4, %5, %6</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Einen Ordner mit Bildern wählen</translation>
    </message>
    <message>
        <source>Choose the video for this camera</source>
        <translation>Das Video dieser Kamera wählen</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Bilder spiegeln</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Mirror the images left to right, after rotation</source>
        <translation>Die Bilder nach dem Drehen seitenverkehrt spiegeln</translation>
    </message>
    <message>
        <source>Background image</source>
        <translation>Hintergrundbild</translation>
    </message>
    <message>
        <source>Image, video or image folder that shows the scene without any target. Objects in the background that have the target&apos;s color are then not mistaken for the target</source>
        <translation>Bild, Video oder Bilderordner, der die Szene ohne Ziel zeigt. Gegenstände im Hintergrund, die die Farbe des Ziels haben, werden dann nicht mit dem Ziel verwechselt</translation>
    </message>
    <message>
        <source>Choose background image</source>
        <translation>Hintergrundbild wählen</translation>
    </message>
    <message>
        <source>Choose an image or a video of the scene without any target</source>
        <translation>Ein Bild oder Video der Szene ohne Ziel wählen</translation>
    </message>
    <message>
        <source>Use current image as background</source>
        <translation>Aktuelles Bild als Hintergrund</translation>
    </message>
    <message>
        <source>Save the current image of this camera as its background image</source>
        <translation>Das aktuelle Bild dieser Kamera als ihr Hintergrundbild speichern</translation>
    </message>
    <message>
        <source>Change background image</source>
        <translation>Hintergrundbild ändern</translation>
    </message>
    <message>
        <source>Choose a background image or video</source>
        <translation>Hintergrundbild oder -video wählen</translation>
    </message>
    <message>
        <source>Change delay</source>
        <translation>Verzögerung ändern</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>How late this camera&apos;s images are, in ms. Dewpoint uses this delay to synchronize the cameras. Calibration with a wand can measure the delay</source>
        <translation>Um wie viele ms die Bilder dieser Kamera zu spät sind. Dewpoint synchronisiert die Kameras mit dieser Verzögerung. Die Kalibrierung mit dem Stab kann die Verzögerung messen</translation>
    </message>
    <message>
        <source>Delay of the images in milliseconds</source>
        <translation>Verzögerung der Bilder in Millisekunden</translation>
    </message>
    <message>
        <source>Keep estimated delay</source>
        <translation>Geschätzte Verzögerung übernehmen</translation>
    </message>
    <message>
        <source>How far the images are rotated clockwise before they are used. The calibration is rotated with them</source>
        <translation>Um wie viel die Bilder vor der Verwendung im Uhrzeigersinn gedreht werden. Die Kalibrierung wird mitgedreht</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Kalibrierung importieren…</translation>
    </message>
    <message>
        <source>Import the calibration of the cameras from a file of Dewpoint or another program</source>
        <translation>Die Kalibrierung der Kameras aus einer Datei von Dewpoint oder einem anderen Programm importieren</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraTable</name>
    <message>
        <source>rtsp://192.168.0.10/stream, or a device number such as 0</source>
        <translation>rtsp://192.168.0.10/stream oder eine Gerätenummer wie 0</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %3 frames per second · %n frames</source>
        <translation>
            <numerusform>✓ %1×%2 · %3 Bilder je Sekunde · %n Bild</numerusform>
            <numerusform>✓ %1×%2 · %3 Bilder je Sekunde · %n Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %n images</source>
        <translation>
            <numerusform>✓ %1×%2 · %n Bild</numerusform>
            <numerusform>✓ %1×%2 · %n Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Live source: it is tested when the project is created</source>
        <translation>Livequelle: wird geprüft, wenn das Projekt erstellt wird</translation>
    </message>
    <message>
        <source>The videos have different frame rates: frame N does not show the same time in each of them.</source>
        <translation>Die Videos haben verschiedene Bildraten: Bild N zeigt nicht in jedem denselben Zeitpunkt.</translation>
    </message>
    <message numerus="yes">
        <source>The videos differ in length: only the first %n frames are used.</source>
        <translation>
            <numerusform>Die Videos sind verschieden lang: Nur das erste Bild (%n) wird verwendet.</numerusform>
            <numerusform>Die Videos sind verschieden lang: Die ersten %n Bilder werden verwendet.</numerusform>
        </translation>
    </message>
    <message>
        <source>The videos differ in size: each camera keeps its own size.</source>
        <translation>Die Videos sind verschieden groß: Jede Kamera behält ihre Größe.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CamerasDialog</name>
    <message>
        <source>Cameras – Dewpoint</source>
        <translation>Kameras – Dewpoint</translation>
    </message>
    <message>
        <source>Fit formats to the USB bus</source>
        <translation>Formate an USB-Bus anpassen</translation>
    </message>
    <message>
        <source>These formats fit the USB bus: %1.</source>
        <translation>Diese Formate passen zum USB-Bus: %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ChangesGuard</name>
    <message>
        <source>Save the project</source>
        <translation>Das Projekt speichern</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml)</source>
        <translation>Dewpoint-Projekte (*.toml)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to this project?</source>
        <translation>Die Änderungen an diesem Projekt speichern?</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorChoice</name>
    <message>
        <source>Color %1</source>
        <translation>Farbe %1</translation>
    </message>
    <message>
        <source>Show this color, so that its range can be changed by hand</source>
        <translation>Diese Farbe des Ziels zeigen, um ihren Bereich von Hand zu ändern</translation>
    </message>
    <message>
        <source>Colors of the target</source>
        <translation>Farben des Ziels</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove this color from the target, and the samples that show it</source>
        <translation>Diese Farbe vom Ziel wegnehmen, samt den Proben, die sie zeigen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorDock</name>
    <message>
        <source>Color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Set box here</source>
        <translation>Rahmen hier setzen</translation>
    </message>
    <message>
        <source>Learn the color here</source>
        <translation>Hier Farbe lernen</translation>
    </message>
    <message>
        <source>Add color sample here</source>
        <translation>Farbprobe hier hinzufügen</translation>
    </message>
    <message>
        <source>Exclude this color</source>
        <translation>Diese Farbe ausschließen</translation>
    </message>
    <message>
        <source>Track this object, starting from a box around it</source>
        <translation>Dieses Objekt verfolgen, ausgehend von einem Rahmen darum</translation>
    </message>
    <message>
        <source>Learn the target&apos;s color from this spot</source>
        <translation>Die Farbe des Ziels an dieser Stelle lernen</translation>
    </message>
    <message>
        <source>Add this color to the colors of the target (Shift-click does the same)</source>
        <translation>Diese Farbe zu den Farben des Ziels hinzufügen (Umschalt-Klick tut dasselbe)</translation>
    </message>
    <message>
        <source>Remove this color from the colors of the target (Ctrl+Shift-click does the same)</source>
        <translation>Diese Farbe aus den Farben des Ziels ausschließen (Strg+Umschalt+Klick tut dasselbe)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorLearner</name>
    <message>
        <source>No color can be learned here, because this camera shows no image.</source>
        <translation>Hier lässt sich keine Farbe lernen, weil diese Kamera kein Bild zeigt.</translation>
    </message>
    <message>
        <source>Click the target first. Then exclude colors of other objects.</source>
        <translation>Klicken Sie zuerst das Ziel an. Schließen Sie dann Farben anderer Objekte aus.</translation>
    </message>
    <message>
        <source>Exclude color</source>
        <translation>Farbe ausschließen</translation>
    </message>
    <message>
        <source>Add color sample</source>
        <translation>Farbprobe hinzufügen</translation>
    </message>
    <message>
        <source>Learn color</source>
        <translation>Farbe lernen</translation>
    </message>
    <message>
        <source>Remove color sample</source>
        <translation>Farbprobe entfernen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorLocker</name>
    <message>
        <source>These settings of %1 cannot be locked: %2.</source>
        <translation>Diese Einstellungen von %1 lassen sich nicht sperren: %2.</translation>
    </message>
    <message>
        <source>%1 has no control for these settings and may change them automatically: %2.</source>
        <translation>%1 bietet für diese Größen keine Einstellung und ändert sie vielleicht selbsttätig: %2.</translation>
    </message>
    <message>
        <source>Only cameras that are connected to this computer can be locked. For network cameras, use their own settings.</source>
        <translation>Nur Kameras, die an diesem Computer angeschlossen sind, können gesperrt werden. Verwenden Sie bei Netzwerkkameras deren eigene Einstellungen.</translation>
    </message>
    <message>
        <source>The color settings of these cameras are now locked: %1.</source>
        <translation>Die Farbeinstellungen dieser Kameras sind jetzt gesperrt: %1.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>These cameras adjust their colors automatically: %1. The learned color may no longer fit when the light changes.</source>
        <translation>Diese Kameras passen ihre Farben automatisch an: %1. Die gelernte Farbe passt womöglich nicht mehr, wenn sich das Licht ändert.</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>Farben sperren</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPanel</name>
    <message>
        <source>Analyzing images…</source>
        <translation>Bilder werden ausgewertet…</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>Noch kein Ziel</translation>
    </message>
    <message>
        <source>A new target</source>
        <translation>Ein neues Ziel</translation>
    </message>
    <message>
        <source>Click the object to track in any camera image.</source>
        <translation>Klicken Sie in einem Kamerabild das Objekt an, das verfolgt werden soll.</translation>
    </message>
    <message>
        <source>Change color range</source>
        <translation>Farbbereich ändern</translation>
    </message>
    <message>
        <source>Click the object to track</source>
        <translation>Das Objekt anklicken, das verfolgt werden soll</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it</source>
        <translation>Das Objekt anklicken oder einen Rahmen darum ziehen</translation>
    </message>
    <message>
        <source>The target is tracked from its box in frame %2 of %1 (%3 × %4 pixels). This method needs no color. To set another box, press Box and click the object.</source>
        <translation>Das Ziel wird ab seinem Rahmen in Bild %2 von %1 verfolgt (%3 × %4 Pixel). Dieses Verfahren braucht keine Farbe. Für einen anderen Rahmen drücken Sie „Rahmen“ und klicken das Objekt an.</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it in any camera view.</source>
        <translation>Klicken Sie das Objekt in einer Kameraansicht an, oder ziehen Sie einen Rahmen darum.</translation>
    </message>
    <message>
        <source>Remove color</source>
        <translation>Farbe entfernen</translation>
    </message>
    <message>
        <source>To set the target&apos;s color, drag the ring and the bars, or press Learn and click the target.</source>
        <translation>Um die Farbe des Ziels einzustellen, ziehen Sie den Ring und die Balken, oder drücken Sie „Lernen“, und klicken Sie das Ziel an.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPicker</name>
    <message>
        <source>H&amp;ue</source>
        <translation>&amp;Farbton</translation>
    </message>
    <message>
        <source>&amp;Saturation</source>
        <translation>&amp;Sättigung</translation>
    </message>
    <message>
        <source>&amp;Intensity</source>
        <translation>&amp;Intensität</translation>
    </message>
    <message>
        <source>Start of the hue range, 0 to 360 degrees. If it is larger than the end, the range passes through red (0 degrees)</source>
        <translation>Anfang des Farbtonbereichs, 0 bis 360 Grad. Ist er größer als das Ende, geht der Bereich durch Rot (0 Grad)</translation>
    </message>
    <message>
        <source>End of the hue range, 0 to 360 degrees</source>
        <translation>Ende des Farbtonbereichs, 0 bis 360 Grad</translation>
    </message>
    <message>
        <source>Drag the ends or the center of the range. Keyboard: Tab selects a handle, arrow keys move it (ten times as far with Shift)</source>
        <translation>Ziehen Sie die Enden oder die Mitte des Bereichs. Tastatur: Tab wählt einen Griff, Pfeiltasten bewegen ihn (mit Umschalt zehnmal so weit)</translation>
    </message>
    <message>
        <source>Range of hues</source>
        <translation>Bereich der Farbtöne</translation>
    </message>
    <message>
        <source>Range of saturation</source>
        <translation>Bereich der Sättigung</translation>
    </message>
    <message>
        <source>Range of intensity</source>
        <translation>Bereich der Intensität</translation>
    </message>
    <message>
        <source>Smallest saturation, 0 to 1</source>
        <translation>Kleinste Sättigung, 0 bis 1</translation>
    </message>
    <message>
        <source>Largest saturation, 0 to 1</source>
        <translation>Größte Sättigung, 0 bis 1</translation>
    </message>
    <message>
        <source>Smallest intensity, 0 to 1</source>
        <translation>Kleinste Intensität, 0 bis 1</translation>
    </message>
    <message>
        <source>Largest intensity, 0 to 1</source>
        <translation>Größte Intensität, 0 bis 1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorSampleList</name>
    <message>
        <source>Learned from</source>
        <translation>Gelernt aus</translation>
    </message>
    <message>
        <source>Samples from which the color was learned</source>
        <translation>Proben, aus denen die Farbe gelernt wurde</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>excluded: %1, frame %2, pixel %3, %4</source>
        <translation>ausgeschlossen: %1, Bild %2, Pixel %3, %4</translation>
    </message>
    <message>
        <source>%1, frame %2, pixel %3, %4</source>
        <translation>%1, Bild %2, Pixel %3, %4</translation>
    </message>
    <message>
        <source>Remove the selected sample and learn from the others (Del). If the sample is marked “found”, it becomes an excluded sample.</source>
        <translation>Die gewählte Probe entfernen und aus den übrigen lernen (Entf). Ist die Probe mit „gefunden“ bezeichnet, wird sie zu einer ausgeschlossenen Probe.</translation>
    </message>
    <message>
        <source>Shift-click in an image to add a sample, Ctrl+Shift-click or Alt-click to exclude one. Samples marked “found” were detected in other cameras.</source>
        <translation>Umschalt+Klick in einem Bild fügt eine Probe hinzu, Strg+Umschalt+Klick oder Alt+Klick schließt eine aus. Mit „gefunden“ bezeichnete Proben wurden in anderen Kameras erkannt.</translation>
    </message>
    <message>
        <source>found: %1, frame %2, pixel %3, %4</source>
        <translation>gefunden: %1, Bild %2, Pixel %3, %4</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>Was möchten Sie tun?</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Aktionen suchen</translation>
    </message>
    <message>
        <source>Actions found</source>
        <translation>Gefundene Aktionen</translation>
    </message>
    <message>
        <source>No action is called “%1”.</source>
        <translation>Keine Aktion heißt „%1“.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ControlForm</name>
    <message>
        <source>From %1 to %2; default %3</source>
        <translation>Von %1 bis %2; Standardwert %3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionMode</name>
    <message>
        <source>Correct position</source>
        <translation>Position korrigieren</translation>
    </message>
    <message>
        <source>There is no correction in this frame.</source>
        <translation>In diesem Bild gibt es keine Korrektur.</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>Korrektur entfernen</translation>
    </message>
    <message>
        <source>Set the target&apos;s position in this frame to this point; tracking continues from there</source>
        <translation>Die Position des Ziels in diesem Bild auf diesen Punkt setzen; von dort wird weiter verfolgt</translation>
    </message>
    <message>
        <source>Drag the target to its true position in one image. To set its depth as well, do the same in a second image. Press Esc to finish.</source>
        <translation>Ziehen Sie das Ziel in einem Bild an seine wahre Position. Um auch die Tiefe festzulegen, tun Sie dasselbe in einem zweiten Bild. Esc beendet es.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionTool</name>
    <message>
        <source>Drag the target to its true position</source>
        <translation>Ziehen Sie das Ziel an seine wahre Position</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter sets the target&apos;s position there</source>
        <translation>Bild von %1: Pfeiltasten bewegen ein Kreuz, Eingabe setzt die Position des Ziels dort</translation>
    </message>
    <message>
        <source>There is no target yet: learn its color first.</source>
        <translation>Es gibt noch kein Ziel: Lernen Sie zuerst seine Farbe.</translation>
    </message>
    <message>
        <source>Frames are being tracked again: wait until tracking has finished, or pause it.</source>
        <translation>Bilder werden neu verfolgt: Warten Sie, bis die Verfolgung fertig ist, oder halten Sie sie an.</translation>
    </message>
    <message>
        <source>Select a target in the panel Target first, or drag the estimate of a target.</source>
        <translation>Wählen Sie zuerst im Bereich „Ziel“ ein Ziel, oder ziehen Sie die Schätzung eines Ziels.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CoverageMap</name>
    <message>
        <source>%1: %2 detections, in %3 of %4 regions of the image</source>
        <translation>%1: %2 Erkennungen in %3 von %4 Teilen des Bildes</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CrashReports</name>
    <message>
        <source>Dewpoint closed unexpectedly last time and left a report of what happened.</source>
        <translation>Dewpoint wurde beim letzten Mal unerwartet beendet. Ein Bericht darüber liegt vor.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translation>Bericht zeigen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CropForm</name>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>Pixels to cut off at this edge, after rotation and mirroring. The calibration is converted. Color samples and boxes in the part that is cut off are removed; Undo brings them back</source>
        <translation>Pixel, die nach dem Drehen und Spiegeln an diesem Rand abgeschnitten werden. Die Kalibrierung wird umgerechnet. Farbproben und Rahmen im abgeschnittenen Teil werden entfernt; „Rückgängig“ stellt sie wieder her</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DelayEstimate</name>
    <message>
        <source>Keep</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Add the estimated delay to the delay of this camera in the project</source>
        <translation>Die geschätzte Verzögerung zur Verzögerung dieser Kamera im Projekt addieren</translation>
    </message>
    <message>
        <source>This delay is estimated from the motion of the targets, and corrected while tracking. To switch this off, set the parameter “Delay spread” to 0</source>
        <translation>Diese Verzögerung wird aus der Bewegung der Ziele geschätzt und beim Verfolgen korrigiert. Um dies abzuschalten, setzen Sie den Parameter „Streuung der Verzögerungen“ auf 0</translation>
    </message>
    <message>
        <source>Estimate: %1 later than %2, ±%3</source>
        <translation>Schätzung: %1 später als %2, ±%3</translation>
    </message>
    <message>
        <source>Estimate: %1 earlier than %2, ±%3</source>
        <translation>Schätzung: %1 früher als %2, ±%3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DeviceQuestion</name>
    <message>
        <source>Use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>Cameras…</source>
        <translation>Kameras…</translation>
    </message>
    <message>
        <source>Several devices may be the camera %1 (%2). Which one is it?</source>
        <translation>Mehrere Geräte könnten die Kamera %1 (%2) sein. Welches ist es?</translation>
    </message>
    <message>
        <source>The device of the camera %1 is not connected: %2. Plug it in, or choose another one.</source>
        <translation>Das Gerät der Kamera %1 ist nicht angeschlossen: %2. Schließen Sie es an oder wählen Sie ein anderes.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DockTitle</name>
    <message>
        <source>Float or dock this view (to maximize the view, double-click its title)</source>
        <translation>Diese Ansicht lösen oder andocken (ein Doppelklick auf ihren Titel maximiert sie)</translation>
    </message>
    <message>
        <source>Show all views</source>
        <translation>Alle Ansichten zeigen</translation>
    </message>
    <message>
        <source>Restore the other views (Esc, or double-click here)</source>
        <translation>Die anderen Ansichten wiederherstellen (Esc oder Doppelklick hier)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Document</name>
    <message>
        <source>Change “%1”</source>
        <translation>„%1“ ändern</translation>
    </message>
    <message>
        <source>Track with method “%1”</source>
        <translation>Mit dem Verfahren „%1“ verfolgen</translation>
    </message>
    <message>
        <source>Reset “%1”</source>
        <translation>„%1“ zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Alle Parameter zurücksetzen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DropZone</name>
    <message>
        <source>Drop or click to add videos</source>
        <translation>Videos hierher ziehen oder klicken</translation>
    </message>
    <message>
        <source>One video or image folder per camera; you can also drop a calibration file</source>
        <translation>Ein Video oder Bilderordner je Kamera; auch eine Kalibrierungsdatei lässt sich hier ablegen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExchangeDialog</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>The file, or the folder with a file for each camera</source>
        <translation>Die Datei, oder der Ordner mit einer Datei je Kamera</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Choose the file to read or write</source>
        <translation>Die Datei suchen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Choose a file. A preview of the result is shown here before anything changes.</source>
        <translation>Wählen Sie eine Datei. Eine Vorschau des Ergebnisses steht hier, bevor sich etwas ändert.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close without changing anything</source>
        <translation>Schließen, ohne etwas zu ändern</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExperimentDialog</name>
    <message>
        <source>Canceled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Experimente</translation>
    </message>
    <message>
        <source>Folder for the report, its pictures and its numbers</source>
        <translation>Ordner für den Bericht, seine Bilder und seine Zahlen</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder of the report</source>
        <translation>Den Ordner des Berichts wählen</translation>
    </message>
    <message>
        <source>Experiment progress</source>
        <translation>Fortschritt des Experiments</translation>
    </message>
    <message>
        <source>Run the chosen experiment (Enter)</source>
        <translation>Das gewählte Experiment ausführen (Eingabe)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop the experiment without writing anything</source>
        <translation>Das Experiment anhalten, ohne etwas zu schreiben</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Show the last report in the web browser</source>
        <translation>Den letzten Bericht im Browser zeigen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation>Ordner des Berichts</translation>
    </message>
    <message>
        <source>Choose the folder for the report first.</source>
        <translation>Wählen Sie zuerst den Ordner für den Bericht.</translation>
    </message>
    <message>
        <source>Running “%1”…</source>
        <translation>„%1“ läuft …</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>Der Bericht liegt in %1.</translation>
    </message>
    <message>
        <source>Runs per case</source>
        <translation>Läufe je Fall</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ausführen</translation>
    </message>
    <message>
        <source>Recordings folder</source>
        <translation>Ordner der Aufnahmen</translation>
    </message>
    <message>
        <source>Clothes</source>
        <translation>Kleidung</translation>
    </message>
    <message>
        <source>Whether the simulated people wear different clothes</source>
        <translation>Ob die simulierten Personen verschiedene Kleidung tragen</translation>
    </message>
    <message>
        <source>both kinds</source>
        <translation>beide Arten</translation>
    </message>
    <message>
        <source>different</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>similar</source>
        <translation>ähnlich</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>no folder: only a rendered clip</source>
        <translation>kein Ordner: nur ein berechneter Film</translation>
    </message>
    <message>
        <source>Folder with the recordings juggle1 and otb; without a folder, only a rendered clip is used</source>
        <translation>Ordner mit den Aufnahmen juggle1 und otb; ohne Ordner wird nur ein berechneter Film verwendet</translation>
    </message>
    <message>
        <source>Choose the folder of the recordings</source>
        <translation>Den Ordner der Aufnahmen wählen</translation>
    </message>
    <message>
        <source>How often each case is run, each time with another seed. More runs take longer and give more certain results.</source>
        <translation>Wie oft jeder Fall gerechnet wird, jedes Mal mit einer anderen Startzahl. Mehr Läufe dauern länger und liefern sicherere Ergebnisse.</translation>
    </message>
    <message>
        <source>No program was found that can show the report. The report is in %1.</source>
        <translation>Es wurde kein Programm gefunden, das den Bericht anzeigen kann. Der Bericht liegt in %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportDialog</name>
    <message>
        <source>Export trajectory</source>
        <translation>Bahn exportieren</translation>
    </message>
    <message>
        <source>Save figure</source>
        <translation>Abbildung speichern</translation>
    </message>
    <message>
        <source>Figures (*.svg *.pdf)</source>
        <translation>Abbildungen (*.svg *.pdf)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>The export was canceled.</source>
        <translation>Der Export wurde abgebrochen.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>Datei, die geschrieben wird</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen…</translation>
    </message>
    <message>
        <source>Choose the file to write</source>
        <translation>Die Datei wählen, die geschrieben wird</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop the export or the preview; files that already exist stay unchanged</source>
        <translation>Den Export oder die Vorschau anhalten; vorhandene Dateien bleiben unverändert</translation>
    </message>
    <message>
        <source>Figure…</source>
        <translation>Abbildung…</translation>
    </message>
    <message>
        <source>Save a figure of the trajectory as SVG or PDF: x, y, z over time, and the view from above</source>
        <translation>Eine Abbildung der Bahn als SVG oder PDF speichern: x, y, z über der Zeit und die Ansicht von oben</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Write the file in the background</source>
        <translation>Die Datei im Hintergrund schreiben</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close; a running export continues</source>
        <translation>Schließen; ein laufender Export geht weiter</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 gibt es schon; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>The program that will read the file</source>
        <translation>Das Programm, das die Datei lesen soll</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Only checked targets are exported; if none is checked, all are exported</source>
        <translation>Nur angekreuzte Ziele werden exportiert; ist keines angekreuzt, alle</translation>
    </message>
    <message>
        <source>Estimates</source>
        <translation>Schätzungen</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>What to write while the position is unknown</source>
        <translation>Was geschrieben wird, solange die Position unbekannt ist</translation>
    </message>
    <message>
        <source>Longest gap</source>
        <translation>Längste Lücke</translation>
    </message>
    <message>
        <source>Longest gap to fill, 0.01 to 60 s</source>
        <translation>Längste Lücke, die gefüllt wird, 0,01 bis 60 s</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Weltachsen</translation>
    </message>
    <message>
        <source>Axis that points up in the file</source>
        <translation>Achse, die in der Datei nach oben zeigt</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>Unit of positions in the file</source>
        <translation>Einheit der Orte in der Datei</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>wie aufgenommen</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> pro Sekunde</translation>
    </message>
    <message>
        <source>smoothed after the run</source>
        <translation>nach dem Lauf geglättet</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>lassen</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>füllen</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z nach oben</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y nach oben</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Earliest time to export, 0 to 1,000,000 s</source>
        <translation>Frühester Zeitpunkt, der exportiert wird, 0 bis 1.000.000 s</translation>
    </message>
    <message>
        <source>Latest time to export, 0 to 1,000,000 s</source>
        <translation>Spätester Zeitpunkt, der exportiert wird, 0 bis 1.000.000 s</translation>
    </message>
    <message>
        <source>Rows per second, 0.001 to 10,000. Positions between frames are interpolated</source>
        <translation>Zeilen pro Sekunde, 0,001 bis 10.000. Positionen zwischen den Bildern werden interpoliert</translation>
    </message>
    <message>
        <source>As tracked: estimated during the run, from earlier frames alone. Smoothed: estimated after the run, from earlier and later frames</source>
        <translation>Wie verfolgt: während des Laufs geschätzt, nur aus früheren Bildern. Geglättet: nach dem Lauf geschätzt, aus früheren und späteren Bildern</translation>
    </message>
    <message>
        <source>Notes at the top of the file</source>
        <translation>Angaben am Anfang der Datei</translation>
    </message>
    <message>
        <source>Lines that describe the run: method, seed, parameters, units and axes. Without them, a CSV file begins with the names of its columns. TRC and C3D files have no notes</source>
        <translation>Zeilen, die den Lauf beschreiben: Verfahren, Startwert, Parameter, Einheiten und Achsen. Ohne sie beginnt eine CSV-Datei mit den Namen ihrer Spalten. TRC- und C3D-Dateien haben keine Angaben</translation>
    </message>
    <message>
        <source>as tracked (live)</source>
        <translation>wie verfolgt (live)</translation>
    </message>
    <message>
        <source>%1 (usual for this format)</source>
        <translation>%1 (bei diesem Format üblich)</translation>
    </message>
    <message>
        <source>tracked only up to %1</source>
        <translation>nur bis %1 verfolgt</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportOutcome</name>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Open the folder of the file that was written</source>
        <translation>Den Ordner der geschriebenen Datei öffnen</translation>
    </message>
    <message>
        <source>No file manager was found. The path of the file is %1.</source>
        <translation>Kein Dateimanager wurde gefunden. Der Pfad der Datei ist %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExposureBars</name>
    <message>
        <source>Brightness of the target&apos;s pixels</source>
        <translation>Helligkeit der Pixel des Ziels</translation>
    </message>
    <message>
        <source>Brightness of the target&apos;s pixels, from black on the left to white on the right. The highlighted bars at the two ends count pixels that are too dark or overexposed: these pixels have lost their color.</source>
        <translation>Helligkeit der Pixel des Ziels, von Schwarz links bis Weiß rechts. Die hervorgehobenen Balken an beiden Enden zählen Pixel, die zu dunkel oder überbelichtet sind: Diese Pixel haben ihre Farbe verloren.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExposureView</name>
    <message>
        <source>Exposure: no target is visible in this camera</source>
        <translation>Belichtung: In dieser Kamera ist kein Ziel zu sehen</translation>
    </message>
    <message>
        <source>Exposure of %1</source>
        <translation>Belichtung von %1</translation>
    </message>
    <message>
        <source>%1 % overexposed · %2 % too dark</source>
        <translation>%1 % überbelichtet · %2 % zu dunkel</translation>
    </message>
    <message>
        <source>%1: %2 % of the target&apos;s pixels are overexposed. Lower the exposure.</source>
        <translation>%1: %2 % der Pixel des Ziels sind überbelichtet. Verringern Sie die Belichtung.</translation>
    </message>
    <message>
        <source>%1: %2 % of the target&apos;s pixels are too dark. Raise the exposure, or add light.</source>
        <translation>%1: %2 % der Pixel des Ziels sind zu dunkel. Erhöhen Sie die Belichtung, oder sorgen Sie für mehr Licht.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FollowAllButton</name>
    <message numerus="yes">
        <source>Follow all %n objects</source>
        <translation>
            <numerusform>%n Objekt verfolgen</numerusform>
            <numerusform>Alle %n Objekte verfolgen</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a target for each of the other objects of this color and size</source>
        <translation>Für jedes der anderen Objekte dieser Farbe und Größe ein Ziel hinzufügen</translation>
    </message>
    <message>
        <source>Follow all objects of one color</source>
        <translation>Alle Objekte einer Farbe verfolgen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FormatChoice</name>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Format in which the device sends its images. Compressed formats, such as MJPG, use less of the bandwidth of the USB bus</source>
        <translation>Format, in dem das Gerät seine Bilder sendet. Komprimierte Formate wie MJPG belasten den USB-Bus weniger</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size of the images, in pixels</source>
        <translation>Größe der Bilder in Pixeln</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Images per second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FrameField</name>
    <message>
        <source>Frame, or time in s</source>
        <translation>Bild, oder Zeit in s</translation>
    </message>
    <message>
        <source>Frame number or time to go to</source>
        <translation>Bildnummer oder Zeit, zu der gegangen wird</translation>
    </message>
    <message>
        <source>Enter a frame from %1 to %2, or a time from %3 to %4.</source>
        <extracomment>%1 and %2 are numbers of frames, %3 and %4 times</extracomment>
        <translation>Geben Sie ein Bild von %1 bis %2 oder eine Zeit von %3 bis %4 ein.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GalleryCard</name>
    <message>
        <source>Opening…</source>
        <translation>Wird geöffnet…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GapList</name>
    <message>
        <source>Gaps of the trajectory</source>
        <translation>Lücken der Bahn</translation>
    </message>
    <message>
        <source>gap from</source>
        <translation>Lücke von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>Time in seconds between the last tracked frame before the gap and the first tracked frame after it</source>
        <translation>Zeit in Sekunden zwischen dem letzten verfolgten Bild vor der Lücke und dem ersten danach</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridForm</name>
    <message>
        <source>Change the reference grid</source>
        <translation>Bezugsgitter ändern</translation>
    </message>
    <message>
        <source>Grid on</source>
        <translation>Gitter auf</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>dem Boden</translation>
    </message>
    <message>
        <source>a wall</source>
        <translation>einer Wand</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>einem Quader</translation>
    </message>
    <message>
        <source>Kind of grid</source>
        <translation>Art des Gitters</translation>
    </message>
    <message>
        <source>Surface of the room on which the grid lies</source>
        <translation>Fläche des Raums, auf der das Gitter liegt</translation>
    </message>
    <message>
        <source>Size along x, y, z</source>
        <translation>Größe entlang x, y, z</translation>
    </message>
    <message>
        <source>Origin x, y, z</source>
        <translation>Ursprung x, y, z</translation>
    </message>
    <message>
        <source>Size along %1</source>
        <translation>Größe entlang %1</translation>
    </message>
    <message>
        <source>Size of the grid, in meters</source>
        <translation>Größe des Gitters, in Metern</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>Ursprung %1</translation>
    </message>
    <message>
        <source>Spacing, rotation</source>
        <translation>Abstand, Drehung</translation>
    </message>
    <message>
        <source>Spacing of the grid</source>
        <translation>Abstand der Gitterlinien</translation>
    </message>
    <message>
        <source>Distance between lines, in meters</source>
        <translation>Abstand zwischen den Linien, in Metern</translation>
    </message>
    <message>
        <source>Rotation of the grid</source>
        <translation>Drehung des Gitters</translation>
    </message>
    <message>
        <source>Rotation about the vertical, counterclockwise as seen from above</source>
        <translation>Drehung um die Senkrechte, von oben gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Opacity of the grid</source>
        <translation>Deckkraft des Gitters</translation>
    </message>
    <message>
        <source>How strongly the grid is drawn over the images</source>
        <translation>Wie kräftig das Gitter über den Bildern gezeichnet wird</translation>
    </message>
    <message>
        <source>Show image edges</source>
        <translation>Bildkanten zeigen</translation>
    </message>
    <message>
        <source>Dim the images except for their edges</source>
        <translation>Die Bilder bis auf ihre Kanten abdunkeln</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Position of the corner at which the axes of the grid start, in meters</source>
        <translation>Position der Ecke, an der die Achsen des Gitters beginnen, in Metern</translation>
    </message>
    <message>
        <source>Show the grid with the camera poses before the changes</source>
        <translation>Das Gitter mit den Lagen der Kameras vor den Änderungen zeigen</translation>
    </message>
    <message>
        <source>Hold down this button to draw the grid with earlier camera poses. Choose below which earlier poses are used. The key B does the same after you have clicked an image</source>
        <translation>Halten Sie diese Schaltfläche gedrückt, um das Gitter mit früheren Lagen der Kameras zu zeichnen. Wählen Sie unten, welche früheren Lagen verwendet werden. Die Taste B tut dasselbe, nachdem Sie ein Bild angeklickt haben</translation>
    </message>
    <message>
        <source>Before shows</source>
        <translation>Vorher zeigt</translation>
    </message>
    <message>
        <source>poses when the panel was opened</source>
        <translation>Kameras beim Öffnen der Ansicht</translation>
    </message>
    <message>
        <source>poses before the last change</source>
        <translation>Kameras vor der letzten Änderung</translation>
    </message>
    <message>
        <source>Earlier camera poses that the button Before shows</source>
        <translation>Frühere Lagen der Kameras, die die Schaltfläche Vorher zeigt</translation>
    </message>
    <message>
        <source>The cameras as they were when you opened this panel, or as they were before the last step that changed a camera</source>
        <translation>Die Kameras, wie sie beim Öffnen dieser Ansicht waren, oder wie sie vor dem letzten Schritt waren, der eine Kamera geändert hat</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridLayer</name>
    <message>
        <source>Grid over the image of %1</source>
        <translation>Gitter über dem Bild von %1</translation>
    </message>
    <message>
        <source>Drag the grid onto the real scene. Click a point to hold it. Arrow keys, W A S D, Q and E move or rotate the camera</source>
        <translation>Ziehen Sie das Gitter auf die wirkliche Szene. Ein Klick hält einen Punkt. Pfeiltasten, W A S D, Q und E bewegen oder drehen die Kamera</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>The earlier grid is outside the visible part of the image</source>
        <translation>Das frühere Gitter liegt außerhalb des sichtbaren Teils des Bildes</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GuidePage</name>
    <message>
        <source>Calibrate…</source>
        <translation>Kalibrieren…</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>Calibration so far</source>
        <translation>Bisherige Kalibrierung</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>Calibration of each camera so far</source>
        <translation>Bisherige Kalibrierung jeder Kamera</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Show the previous step</source>
        <translation>Den vorigen Schritt zeigen</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Show the next step</source>
        <translation>Den nächsten Schritt zeigen</translation>
    </message>
    <message>
        <source>%1 Scale: %2</source>
        <translation>%1 Maßstab: %2</translation>
    </message>
    <message>
        <source>%1 Floor and upward direction: %2</source>
        <translation>%1 Boden und Richtung nach oben: %2</translation>
    </message>
    <message>
        <source>✓ Accuracy in the calibrated volume: %1 (95 %)</source>
        <translation>✓ Genauigkeit im kalibrierten Raum: %1 (95 %)</translation>
    </message>
    <message>
        <source>○ Accuracy in the calibrated volume: not measured</source>
        <translation>○ Genauigkeit im kalibrierten Raum: nicht gemessen</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
    <message>
        <source>Another way…</source>
        <translation>Anderer Weg…</translation>
    </message>
    <message>
        <source>Choose a way to calibrate</source>
        <translation>Weg zur Kalibrierung wählen</translation>
    </message>
    <message>
        <source>The camera positions are only guesses. Calibrate the cameras to get correct 3D positions.</source>
        <translation>Die Kamerapositionen sind nur geraten. Kalibrieren Sie die Kameras, um richtige 3D-Positionen zu erhalten.</translation>
    </message>
    <message>
        <source>✓ measured with this program; ± is the standard deviation. ○ entered, set by hand or read from a file, and not checked. ⚠ only a guess, or too inaccurate.</source>
        <translation>✓ mit diesem Programm gemessen; ± ist die Standardabweichung. ○ eingegeben, von Hand eingestellt oder aus einer Datei gelesen und nicht überprüft. ⚠ nur geraten oder zu ungenau.</translation>
    </message>
    <message>
        <source>Show all ways to calibrate. The calibration so far is kept.</source>
        <translation>Alle Wege zur Kalibrierung zeigen. Die bisherige Kalibrierung bleibt erhalten.</translation>
    </message>
    <message>
        <source>✓ Length check: you measured %1, the calibration gives %2</source>
        <translation>✓ Längenprüfung: Sie haben %1 gemessen, die Kalibrierung ergibt %2</translation>
    </message>
    <message>
        <source>○ Accuracy outside this volume: %1 (95 %, extrapolated)</source>
        <translation>○ Genauigkeit außerhalb dieses Raums: %1 (95 %, extrapoliert)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistogramView</name>
    <message>
        <source>Colors of the box</source>
        <translation>Farben des Rahmens</translation>
    </message>
    <message>
        <source>Color histograms of the bounding box: outlined bars for the reference, filled bars for the current frame. The largest of the 512 bins are shown, each in its own color.</source>
        <translation>Farbhistogramme des Rahmens: leere Balken, wie er angegeben wurde, gefüllte Balken, wie er jetzt ist. Gezeigt werden die größten von 512 Klassen, jede in ihrer Farbe.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistoryDock</name>
    <message>
        <source>Initial state</source>
        <translation>Anfangszustand</translation>
    </message>
    <message>
        <source>History of changes</source>
        <translation>Verlauf der Änderungen</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ImagePickTool</name>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter clicks there</source>
        <translation>Bild von %1: Pfeiltasten bewegen ein Kreuz, Eingabe klickt dort</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LearnModes</name>
    <message>
        <source>What a click in an image does</source>
        <translation>Was ein Klick in ein Bild bewirkt</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Add sample</source>
        <translation>Probe hinzufügen</translation>
    </message>
    <message>
        <source>Exclude</source>
        <translation>Ausschließen</translation>
    </message>
    <message>
        <source>Learn the color first: click the target in a camera image.</source>
        <translation>Erst die Farbe lernen: das Ziel in einem Kamerabild anklicken.</translation>
    </message>
    <message>
        <source>Click: exclude a color · Esc: stop</source>
        <translation>Klick: Farbe ausschließen · Esc: beenden</translation>
    </message>
    <message>
        <source>Click the object in a camera image, or drag a box around it.
When this button is off, Shift-click does the same.</source>
        <translation>Das Objekt in einem Kamerabild anklicken oder einen Rahmen darum ziehen.
Wenn diese Schaltfläche aus ist, tut Umschalt-Klick dasselbe.</translation>
    </message>
    <message>
        <source>Click another part of the target, or the target in different light, to add its color.
When this button is off, Shift-click does the same.</source>
        <translation>Eine andere Stelle des Ziels anklicken, oder das Ziel in anderem Licht, um die Farbe hinzuzufügen.
Wenn diese Schaltfläche aus ist, tut Umschalt-Klick dasselbe.</translation>
    </message>
    <message>
        <source>Click the target in a camera image, or drag a box around it,
to learn its color again.</source>
        <translation>Klicken Sie das Ziel in einem Kamerabild an, oder ziehen Sie einen
Rahmen darum, um seine Farbe neu zu lernen.</translation>
    </message>
    <message>
        <source>Click something that has the target&apos;s color but is not the target, to exclude it.
When this button is off, Ctrl+Shift-click does the same; so does Alt-click, where the desktop does not use it.</source>
        <translation>Etwas anklicken, das die Farbe des Ziels hat, aber nicht das Ziel ist, um es auszuschließen.
Wenn diese Schaltfläche aus ist, tut Strg+Umschalt+Klick dasselbe; auch Alt+Klick, wo der Desktop ihn nicht benutzt.</translation>
    </message>
    <message>
        <source>Click: add a sample · Ctrl+Shift: exclude · Esc: stop</source>
        <translation>Klick: Probe hinzufügen · Strg+Umschalt: ausschließen · Esc: beenden</translation>
    </message>
    <message>
        <source>Click: learn · Shift: add · Ctrl+Shift: exclude · Esc: stop</source>
        <translation>Klick: lernen · Umschalt: hinzufügen · Strg+Umschalt: ausschließen · Esc: beenden</translation>
    </message>
    <message>
        <source>Click: add a sample · Esc: stop</source>
        <translation>Klick: Probe hinzufügen · Esc: beenden</translation>
    </message>
    <message>
        <source>Click: learn · Shift: add · Esc: stop</source>
        <translation>Klick: lernen · Umschalt: hinzufügen · Esc: beenden</translation>
    </message>
    <message>
        <source>Click the new target · Esc: stop</source>
        <translation>Das neue Ziel anklicken · Esc: beenden</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LegendPicture</name>
    <message>
        <source>Cross: the estimate, the weighted mean of the particles.</source>
        <translation>Kreuz: die Schätzung, das gewichtete Mittel der Partikel.</translation>
    </message>
    <message>
        <source>Solid ellipse: the target is inside with a probability of 95 %. A smaller ellipse is more certain.</source>
        <translation>Durchgezogene Ellipse: Das Ziel ist mit einer Wahrscheinlichkeit von 95 % darin. Eine kleinere Ellipse ist sicherer.</translation>
    </message>
    <message>
        <source>White diamond: the true position of the target, known only in simulated scenes such as the demo.</source>
        <translation>Weiße Raute: die wahre Position des Ziels, bekannt nur in simulierten Szenen wie der Demo.</translation>
    </message>
    <message>
        <source>Triangle: the particle of highest weight (View › Show best particle).</source>
        <translation>Dreieck: das Partikel mit dem höchsten Gewicht (Ansicht › Bestes Partikel zeigen).</translation>
    </message>
    <message>
        <source>Line across the image: the line of sight of another camera, shown while you drag the target. The target must lie on this line.</source>
        <translation>Linie durch das Bild: die Sichtlinie einer anderen Kamera, gezeigt, während Sie das Ziel ziehen. Das Ziel muss auf dieser Linie liegen.</translation>
    </message>
    <message>
        <source>Dots: particles. Each one is a guess of where the target is. Brighter particles fit the images better.</source>
        <translation>Punkte: Partikel. Jedes ist eine Vermutung, wo das Ziel ist. Hellere Partikel passen besser zu den Bildern.</translation>
    </message>
    <message>
        <source>Tinted and outlined: regions with the color of the target (View › Show mask).</source>
        <translation>Getönt und umrandet: Bereiche mit der Farbe des Ziels (Ansicht › Maske zeigen).</translation>
    </message>
    <message>
        <source>Dashed ellipse: the size of the target itself, if the target is not a ball.</source>
        <translation>Gestrichelte Ellipse: die Größe des Ziels selbst, wenn das Ziel kein Ball ist.</translation>
    </message>
    <message>
        <source>Box in a corner: the particles, enlarged, if they are too close together to be seen in the view. A line shows where they are, and the bar shows the scale.</source>
        <translation>Kasten in einer Ecke: die Partikel, vergrößert, wenn sie für die Ansicht zu dicht beieinander liegen. Eine Linie zeigt, wo sie sind, und der Balken zeigt den Maßstab.</translation>
    </message>
    <message>
        <source>Dark band along a path in the bird&apos;s-eye view: the time range that is selected in the timeline. Press Esc in the timeline to remove the selection.</source>
        <translation>Dunkles Band entlang eines Weges in der Vogelperspektive: der Zeitbereich, der in der Zeitleiste ausgewählt ist. Esc in der Zeitleiste hebt die Auswahl auf.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MainWindow</name>
    <message>
        <source>Dewpoint</source>
        <translation>Dewpoint</translation>
    </message>
    <message>
        <source>%1[*] – Dewpoint</source>
        <translation>%1[*] – Dewpoint</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualCalibration</name>
    <message>
        <source>Drag the grid in %1</source>
        <translation>Gitter in %1 ziehen</translation>
    </message>
    <message>
        <source>Cannot move further: a grid point would leave the camera&apos;s field of view</source>
        <translation>Weiter geht es nicht: Ein Gitterpunkt würde das Sichtfeld der Kamera verlassen</translation>
    </message>
    <message>
        <source>Cannot move further: this grid point and the held grid points lie on one line</source>
        <translation>Weiter geht es nicht: Dieser Gitterpunkt und die gehaltenen liegen auf einer Geraden</translation>
    </message>
    <message>
        <source>Cannot move further: no nearby camera pose keeps the held grid points in place</source>
        <translation>Weiter geht es nicht: Keine Kameralage in der Nähe lässt die gehaltenen Gitterpunkte an ihrem Ort</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>up</source>
        <translation>aufwärts</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>%1: change focal length by %2 %</source>
        <translation>%1: Brennweite um %2 % ändern</translation>
    </message>
    <message>
        <source>At most three grid points can be held in place. To release one, click it</source>
        <translation>Es können höchstens drei Gitterpunkte festgehalten werden. Klicken Sie auf einen, um ihn loszulassen</translation>
    </message>
    <message>
        <source>Three held points fix the pose. Release one of them, or turn on “Also fit the focal length when three points are held”</source>
        <translation>Drei gehaltene Punkte legen die Lage fest. Lassen Sie einen davon los, oder schalten Sie „Bei drei gehaltenen Punkten die Brennweite anpassen“ ein</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualCalibrationPage</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Reference grid</source>
        <translation>Bezugsgitter</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Gemessene Punkte</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Drag the grid in an image until it matches the real scene. Click a grid point to hold it in place. Turn the wheel to zoom; double-click beside the grid points to see the whole image.</source>
        <translation>Ziehen Sie das Gitter in einem Bild, bis es zur wirklichen Szene passt. Ein Klick auf einen Gitterpunkt hält ihn fest. Das Mausrad vergrößert; ein Doppelklick neben den Gitterpunkten zeigt das ganze Bild.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualWindow</name>
    <message>
        <source>Manual – Dewpoint</source>
        <translation>Handbuch – Dewpoint</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Seiten des Handbuchs</translation>
    </message>
    <message>
        <source>Go back to the previous page</source>
        <translation>Zurück zur vorigen Seite</translation>
    </message>
    <message>
        <source>Go forward one page</source>
        <translation>Vorwärts zur nächsten Seite</translation>
    </message>
    <message>
        <source>The manual was not found. It is expected in the folder %1.</source>
        <translation>Das Handbuch wurde nicht gefunden. Es wird im Ordner %1 erwartet.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MarkerEditor</name>
    <message>
        <source>Name of the marker</source>
        <translation>Name der Marke</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>Marke %1</translation>
    </message>
    <message>
        <source>Add a marker</source>
        <translation>Marke setzen</translation>
    </message>
    <message>
        <source>Remove a marker</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Rename a marker</source>
        <translation>Marke umbenennen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageHistory</name>
    <message>
        <source>Messages – Dewpoint</source>
        <translation>Meldungen – Dewpoint</translation>
    </message>
    <message>
        <source>Messages, the newest last</source>
        <translation>Meldungen, die neueste zuletzt</translation>
    </message>
    <message>
        <source>There have been no messages yet.</source>
        <translation>Bisher gab es keine Meldungen.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy all messages as text</source>
        <translation>Alle Meldungen als Text kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageRow</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MissingFilesOffer</name>
    <message>
        <source>%1 was not found in %2.</source>
        <translation>%1 wurde in %2 nicht gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>%n files of this project were not found: %1.</source>
        <translation>
            <numerusform>%n Datei dieses Projekts wurde nicht gefunden: %1.</numerusform>
            <numerusform>%n Dateien dieses Projekts wurden nicht gefunden: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>Suchen…</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The project was opened with the files that you located. Save the project to keep their new paths.</source>
        <translation>Das Projekt wurde mit den von Ihnen angegebenen Dateien geöffnet. Speichern Sie das Projekt, um die neuen Pfade zu behalten.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a file, the name of its camera</comment>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::NewProjectPage</name>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>Video files, one per camera</source>
        <translation>Videodateien, eine je Kamera</translation>
    </message>
    <message>
        <source>A folder of images, one per frame</source>
        <translation>Ein Ordner mit Bildern, eines je Zeitpunkt</translation>
    </message>
    <message>
        <source>All cameras connected to this computer</source>
        <translation>Alle an diesen Rechner angeschlossenen Kameras</translation>
    </message>
    <message>
        <source>Enter a device number or a network stream</source>
        <translation>Eine Gerätenummer oder einen Netzwerkstrom eingeben</translation>
    </message>
    <message>
        <source>Remove the selected cameras</source>
        <translation>Die gewählten Kameras entfernen</translation>
    </message>
    <message>
        <source>Create the project and show its first images</source>
        <translation>Das Projekt erstellen und seine ersten Bilder zeigen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Go back without creating a project</source>
        <translation>Zurück, ohne ein Projekt zu erstellen</translation>
    </message>
    <message>
        <source>Name of the project</source>
        <translation>Name des Projekts</translation>
    </message>
    <message>
        <source>Frame rate of image folders, 0.1 to 10,000 per second</source>
        <translation>Bildrate von Bilderordnern, 0,1 bis 10.000 je Sekunde</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Images from</source>
        <translation>Bilder aus</translation>
    </message>
    <message>
        <source>Cameras in the new project</source>
        <translation>Kameras des neuen Projekts</translation>
    </message>
    <message>
        <source>Choose one video per camera</source>
        <translation>Ein Video je Kamera wählen</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)</source>
        <translation>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Einen Ordner mit Bildern wählen</translation>
    </message>
    <message>
        <source>No camera is connected to this computer. A network camera can be added by its address.</source>
        <translation>An diesen Rechner ist keine Kamera angeschlossen. Eine Netzwerkkamera lässt sich mit ihrer Adresse hinzufügen.</translation>
    </message>
    <message>
        <source>The calibration uses other camera names. The cameras were matched by order.</source>
        <translation>Die Kalibrierung verwendet andere Kameranamen. Die Kameras wurden nach Reihenfolge zugeordnet.</translation>
    </message>
    <message>
        <source>Add videos…</source>
        <translation>Videos hinzufügen…</translation>
    </message>
    <message>
        <source>Add image folder…</source>
        <translation>Bilderordner hinzufügen…</translation>
    </message>
    <message>
        <source>Add connected cameras</source>
        <translation>Angeschlossene Kameras hinzufügen</translation>
    </message>
    <message>
        <source>Add address</source>
        <translation>Adresse hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Erstellen</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>Images per second:</source>
        <translation>Bilder je Sekunde:</translation>
    </message>
    <message>
        <source>Not a video, image or calibration file: %1.</source>
        <translation>Keine Video-, Bild- oder Kalibrierungsdatei: %1.</translation>
    </message>
    <message>
        <source>One row per camera. The videos must be synchronized: frame N must show the same time in all of them.</source>
        <translation>Eine Zeile je Kamera. Die Videos müssen synchronisiert sein: Bild N muss in allen denselben Zeitpunkt zeigen.</translation>
    </message>
    <message>
        <source>(folder name)</source>
        <translation>(Name des Ordners)</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>%1. Create the project without this file, then choose Calibration › Import calibration.</source>
        <translation>%1. Erstellen Sie das Projekt ohne diese Datei, und wählen Sie dann Kalibrierung › Kalibrierung importieren.</translation>
    </message>
    <message>
        <source>Probably a mistake in the calibration: %1</source>
        <translation>Wahrscheinlich ein Fehler in der Kalibrierung: %1</translation>
    </message>
    <message>
        <source>%1. Choose below how the images differ from those of the calibration.</source>
        <translation>%1. Wählen Sie unten, wie sich die Bilder von denen der Kalibrierung unterscheiden.</translation>
    </message>
    <message>
        <source>%1. For each camera of the project, choose a camera of the file below.</source>
        <translation>%1. Wählen Sie unten für jede Kamera des Projekts eine Kamera der Datei.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::NoticeList</name>
    <message>
        <source>Hide these notices. The status bar shows how many are hidden</source>
        <translation>Diese Hinweise ausblenden. Die Statusleiste zeigt, wie viele ausgeblendet sind</translation>
    </message>
    <message numerus="yes">
        <source>and %n more notice(s)</source>
        <translation>
            <numerusform>und %n weiterer Hinweis</numerusform>
            <numerusform>und %n weitere Hinweise</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OldResultsOffer</name>
    <message>
        <source>Track again</source>
        <translation>Erneut verfolgen</translation>
    </message>
    <message>
        <source>Some frames were tracked with earlier settings.</source>
        <translation>Einige Bilder wurden mit früheren Einstellungen verfolgt.</translation>
    </message>
    <message>
        <source>Tracking began at frame %1, where you clicked. The frames before it are not tracked.</source>
        <translation>Die Verfolgung begann bei Bild %1, das Sie angeklickt haben. Die Bilder davor sind nicht verfolgt.</translation>
    </message>
    <message>
        <source>Track from the first frame</source>
        <translation>Ab dem ersten Bild verfolgen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OutputController</name>
    <message>
        <source>%1: %2 sent, %3 dropped</source>
        <translation>%1: %2 gesendet, %3 verworfen</translation>
    </message>
    <message numerus="yes">
        <source>Sending, %n program(s) connected</source>
        <translation>
            <numerusform>Sendet, %n Programm verbunden</numerusform>
            <numerusform>Sendet, %n Programme verbunden</numerusform>
        </translation>
    </message>
    <message>
        <source>Sending</source>
        <translation>Sendet</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OutputDialog</name>
    <message>
        <source>Change outputs</source>
        <translation>Ausgänge ändern</translation>
    </message>
    <message>
        <source>Outputs – Dewpoint</source>
        <translation>Ausgänge – Dewpoint</translation>
    </message>
    <message>
        <source>Choose where results are sent during a run. Nothing is sent before you choose Run › Send results.</source>
        <translation>Wählen Sie, wohin Ergebnisse während eines Laufs gesendet werden. Gesendet wird erst, wenn Sie Lauf › Ergebnisse senden wählen.</translation>
    </message>
    <message>
        <source>TCP port for JSON lines</source>
        <translation>TCP-Port für JSON-Zeilen</translation>
    </message>
    <message>
        <source>Programs that connect to this port get one line of JSON for each frame</source>
        <translation>Programme, die sich mit diesem Port verbinden, erhalten für jedes Bild eine Zeile JSON</translation>
    </message>
    <message>
        <source>TCP port</source>
        <translation>TCP-Port</translation>
    </message>
    <message>
        <source>Port for WebSocket and web page</source>
        <translation>Port für WebSocket und Webseite</translation>
    </message>
    <message>
        <source>Port of a web page that shows the targets in a browser. At the same port, programs get the results through a WebSocket</source>
        <translation>Port einer Webseite, die die Ziele im Browser zeigt. Am selben Port erhalten Programme die Ergebnisse über ein WebSocket</translation>
    </message>
    <message>
        <source>WebSocket port</source>
        <translation>WebSocket-Port</translation>
    </message>
    <message>
        <source>OSC to</source>
        <translation>OSC an</translation>
    </message>
    <message>
        <source>Computer and UDP port that OSC messages are sent to, such as 127.0.0.1:9000. Empty: off</source>
        <translation>Rechner und UDP-Port, an die OSC-Nachrichten gehen, etwa 127.0.0.1:9000. Leer: aus</translation>
    </message>
    <message>
        <source>TUIO to</source>
        <translation>TUIO an</translation>
    </message>
    <message>
        <source>Computer and UDP port that TUIO 1.1 3D cursors are sent to, such as 127.0.0.1:3333. Empty: off</source>
        <translation>Rechner und UDP-Port, an die TUIO-1.1-3D-Cursor gehen, etwa 127.0.0.1:3333. Leer: aus</translation>
    </message>
    <message>
        <source>CSV file</source>
        <translation>CSV-Datei</translation>
    </message>
    <message>
        <source>File or named pipe that gets one line for each target and frame. Empty: off</source>
        <translation>Datei oder benannte Pipe, die für jedes Ziel und Bild eine Zeile erhält. Leer: aus</translation>
    </message>
    <message>
        <source>Who can connect</source>
        <translation>Wer sich verbinden kann</translation>
    </message>
    <message>
        <source>Which computers can connect to the ports. If you allow all computers, anyone in the network can see the results</source>
        <translation>Welche Rechner sich mit den Ports verbinden können. Wenn Sie alle Rechner zulassen, kann jeder im Netzwerk die Ergebnisse sehen</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Axes of the positions that are sent</source>
        <translation>Achsen der gesendeten Positionen</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Unit of the positions that are sent</source>
        <translation>Einheit der gesendeten Positionen</translation>
    </message>
    <message>
        <source>Max. frames per second</source>
        <translation>Max. Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Largest number of frames per second that are sent. 0: all frames</source>
        <translation>Größte Zahl von Bildern pro Sekunde, die gesendet werden. 0: alle Bilder</translation>
    </message>
    <message>
        <source>Token for remote commands</source>
        <translation>Token für Fernbefehle</translation>
    </message>
    <message>
        <source>Programs that send this word can start and stop the run and the recording of the cameras. At least %1 characters. Empty: commands are ignored</source>
        <translation>Programme, die dieses Wort senden, können den Lauf und die Aufnahme der Kameras starten und anhalten. Mindestens %1 Zeichen. Leer: Befehle werden ignoriert</translation>
    </message>
    <message>
        <source>this computer only</source>
        <translation>nur diesen Rechner</translation>
    </message>
    <message>
        <source>all computers in the network</source>
        <translation>alle Rechner im Netzwerk</translation>
    </message>
    <message>
        <source>z up, right-handed (as in Dewpoint)</source>
        <translation>z nach oben, rechtshändig (wie in Dewpoint)</translation>
    </message>
    <message>
        <source>y up, right-handed</source>
        <translation>y nach oben, rechtshändig</translation>
    </message>
    <message>
        <source>y up, left-handed (as in Unity)</source>
        <translation>y nach oben, linkshändig (wie in Unity)</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>Millimeter</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OverlayLegend</name>
    <message>
        <source>Legend of the overlays</source>
        <translation>Legende der Einblendungen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ParameterPanel</name>
    <message>
        <source>The parameters appear here once a project is open.</source>
        <translation>Die Parameter erscheinen hier, sobald ein Projekt geöffnet ist.</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Verfahren</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it in any camera view.</source>
        <translation>Klicken Sie das Objekt in einer Kameraansicht an, oder ziehen Sie einen Rahmen darum.</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>This value is larger than “%1”, so %2 is used instead.</source>
        <translation>Dieser Wert ist größer als „%1“, daher wird stattdessen %2 verwendet.</translation>
    </message>
    <message>
        <source>Tracking method. Changing it restarts tracking; other settings are kept.</source>
        <translation>Verfahren der Verfolgung. Ein Wechsel beginnt die Verfolgung neu; andere Einstellungen bleiben.</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all parameters of this method to their defaults</source>
        <translation>Alle Parameter dieses Verfahrens auf ihre Vorgaben zurücksetzen</translation>
    </message>
    <message>
        <source>Volume of interest</source>
        <translation>Suchraum</translation>
    </message>
    <message>
        <source>Targets are searched for only inside a box.</source>
        <translation>Ziele werden nur in einem Quader gesucht.</translation>
    </message>
    <message>
        <source>Some values in this group differ from their defaults.</source>
        <translation>Einige Werte hier weichen von ihren Vorgaben ab.</translation>
    </message>
    <message>
        <source>This value is smaller than “%1”, so “%1” has no effect.</source>
        <translation>Dieser Wert ist kleiner als „%1“, daher hat „%1“ keine Wirkung.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeopleDock</name>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Click a person in a camera image, or the floor in the bird&apos;s-eye view. Press Esc to cancel.</source>
        <translation>Klicken Sie eine Person in einem Kamerabild an, oder den Boden in der Vogelperspektive. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>Remove a person</source>
        <translation>Person entfernen</translation>
    </message>
    <message>
        <source>Folder for the 3D shapes of people</source>
        <translation>Ordner für die 3D-Formen der Personen</translation>
    </message>
    <message>
        <source>%1 already contains files of an earlier export. Replace them?</source>
        <translation>%1 enthält bereits Dateien eines früheren Exports. Ersetzen?</translation>
    </message>
    <message>
        <source>The run has ended, so the 3D shapes of people were not saved.</source>
        <translation>Der Lauf ist beendet, daher wurden die 3D-Formen der Personen nicht gespeichert.</translation>
    </message>
    <message>
        <source>Saving the 3D shapes of people…</source>
        <translation>Die 3D-Formen der Personen werden gespeichert…</translation>
    </message>
    <message>
        <source>Saved the positions, volumes, hulls and densities of the people in %1 (frames: %2).</source>
        <translation>Positionen, Volumen, Hüllen und Dichten der Personen wurden in %1 gespeichert (Bilder: %2).</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeoplePanel</name>
    <message>
        <source>People in view</source>
        <translation>Anwesende Personen</translation>
    </message>
    <message>
        <source>Progress of learning the background</source>
        <translation>Fortschritt beim Lernen des Hintergrunds</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Position on the floor, x and y in meters</source>
        <translation>Position auf dem Boden, x und y in Metern</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Estimated height in meters; empty if the method does not estimate it</source>
        <translation>Geschätzte Größe in Metern; leer, wenn das Verfahren sie nicht schätzt</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Speed over the floor, in meters per second</source>
        <translation>Tempo über dem Boden, in Metern je Sekunde</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Number of cameras that see the person, out of all cameras</source>
        <translation>Zahl der Kameras, die die Person sehen, von allen Kameras</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time since the person entered, in seconds</source>
        <translation>Zeit, seit die Person gekommen ist, in Sekunden</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>Learning the background: %1 %. Keep the scene empty.</source>
        <translation>Der Hintergrund wird gelernt: %1 %. Bitte nicht ins Bild treten.</translation>
    </message>
    <message>
        <source>Nobody is in view. People appear when two cameras see them.</source>
        <translation>Niemand ist im Bild. Personen erscheinen, wenn zwei Kameras sie sehen.</translation>
    </message>
    <message>
        <source>People in view: %1</source>
        <translation>Personen im Bild: %1</translation>
    </message>
    <message>
        <source>People appear here once a method for people runs.</source>
        <translation>Personen erscheinen hier, sobald ein Verfahren für Personen läuft.</translation>
    </message>
    <message>
        <source>Another person is close</source>
        <translation>Eine andere Person ist nah</translation>
    </message>
    <message>
        <source>Number of the person. No other person gets the same number in this run</source>
        <translation>Nummer der Person. Keine andere Person bekommt in diesem Lauf dieselbe Nummer</translation>
    </message>
    <message>
        <source>Volume of the hull that encloses 95 % of the person, in cubic meters. Empty unless “Show 3D shapes of people” is on</source>
        <translation>Volumen der Hülle, die 95 % der Person umschließt, in Kubikmetern. Leer, solange „3D-Formen der Personen zeigen“ ausgeschaltet ist</translation>
    </message>
    <message>
        <source>● means that another person is close. Until the two are apart again, the method learns nothing new about the colors of this person</source>
        <translation>● bedeutet, dass eine andere Person nah ist. Bis die beiden wieder auseinander sind, lernt das Verfahren nichts Neues über die Farben dieser Person</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlanPage</name>
    <message>
        <source>See how accurately these cameras will measure, and where another camera would help. Drag a camera in the bird&apos;s-eye view to update the map.</source>
        <translation>Sehen Sie, wie genau diese Kameras messen werden und wo eine weitere Kamera helfen würde. Ziehen Sie eine Kamera in der Vogelperspektive, und die Karte ändert sich.</translation>
    </message>
    <message>
        <source>Map of expected errors</source>
        <translation>Karte der erwarteten Fehler</translation>
    </message>
    <message>
        <source>Planned cameras</source>
        <translation>Geplante Kameras</translation>
    </message>
    <message>
        <source>Planned cameras are not saved with the project and take no part in the run. The map does not account for objects that block the view.</source>
        <translation>Geplante Kameras werden nicht mit dem Projekt gespeichert und gehören nicht zum Lauf. Die Karte berücksichtigt keine Objekte, die die Sicht versperren.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerForm</name>
    <message>
        <source>Add planned camera</source>
        <translation>Geplante Kamera hinzufügen</translation>
    </message>
    <message>
        <source>Add a planned camera; you can then drag it in the bird&apos;s-eye view, or enter its position (%1)</source>
        <translation>Eine geplante Kamera hinzufügen; Sie können sie dann in der Vogelperspektive ziehen oder ihre Position eingeben (%1)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the planned camera</source>
        <translation>Die geplante Kamera entfernen</translation>
    </message>
    <message>
        <source>Remove the selected planned camera</source>
        <translation>Die gewählte geplante Kamera entfernen</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>Geplante Kamera</translation>
    </message>
    <message>
        <source>Position x, y, z</source>
        <translation>Position x, y, z</translation>
    </message>
    <message>
        <source>Looks at x, y, z</source>
        <translation>Blickt auf x, y, z</translation>
    </message>
    <message>
        <source>Field of view, image width and height</source>
        <translation>Blickwinkel, Bildbreite und -höhe</translation>
    </message>
    <message>
        <source>Planned position (%1 coordinate)</source>
        <translation>Geplante Position (%1-Koordinate)</translation>
    </message>
    <message>
        <source>Position of the camera, in meters</source>
        <translation>Position der Kamera, in Metern</translation>
    </message>
    <message>
        <source>Planned camera looks at (%1 coordinate)</source>
        <translation>Geplante Kamera blickt auf (%1-Koordinate)</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Blickwinkel</translation>
    </message>
    <message>
        <source>Horizontal field of view of the camera</source>
        <translation>Waagerechter Blickwinkel der Kamera</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>Bildbreite</translation>
    </message>
    <message>
        <source>Image height</source>
        <translation>Bildhöhe</translation>
    </message>
    <message>
        <source>The search places the camera on four walls and a ceiling at this distance from the volume</source>
        <translation>Die Suche setzt die Kamera an vier Wände und eine Decke in diesem Abstand vom Raum</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>Die Suche abbrechen</translation>
    </message>
    <message>
        <source>Stop the search without adding a camera</source>
        <translation>Die Suche beenden, ohne eine Kamera hinzuzufügen</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>none selected</source>
        <translation>keine gewählt</translation>
    </message>
    <message>
        <source>Find best position for %1</source>
        <translation>Beste Position für %1 suchen</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the position where another camera would help most (%1)</source>
        <translation>An Wänden und Decke die Position suchen, an der eine weitere Kamera am meisten helfen würde (%1)</translation>
    </message>
    <message>
        <source>Choose the planned camera whose values are shown below</source>
        <translation>Wählen Sie die geplante Kamera, deren Werte unten gezeigt werden</translation>
    </message>
    <message>
        <source>A point that the planned camera looks at, in meters</source>
        <translation>Ein Punkt, auf den die geplante Kamera blickt, in Metern</translation>
    </message>
    <message>
        <source>Width of the planned camera&apos;s image, in pixels</source>
        <translation>Breite des Bildes der geplanten Kamera, in Pixeln</translation>
    </message>
    <message>
        <source>Height of the planned camera&apos;s image, in pixels</source>
        <translation>Höhe des Bildes der geplanten Kamera, in Pixeln</translation>
    </message>
    <message>
        <source>Distance to walls and ceiling</source>
        <translation>Abstand zu Wänden und Decke</translation>
    </message>
    <message>
        <source>Distance from the volume to the walls and the ceiling</source>
        <translation>Abstand des Raums zu den Wänden und der Decke</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerInstaller</name>
    <message>
        <source>Move %1 in the bird&apos;s-eye view</source>
        <translation>%1 in der Vogelperspektive verschieben</translation>
    </message>
    <message>
        <source>Turn %1 in the bird&apos;s-eye view</source>
        <translation>%1 in der Vogelperspektive drehen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotPanel</name>
    <message>
        <source>Plots of the run</source>
        <translation>Kurven des Laufs</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Choose which plots to show; copy or save plots</source>
        <translation>Gezeigte Kurven wählen; kopieren oder speichern</translation>
    </message>
    <message>
        <source>Choose which plots to show</source>
        <translation>Wählen, welche Kurven gezeigt werden</translation>
    </message>
    <message>
        <source>The plots are on the clipboard as CSV.</source>
        <translation>Die Kurven sind als CSV in der Zwischenablage.</translation>
    </message>
    <message>
        <source>Save the plots</source>
        <translation>Kurven speichern</translation>
    </message>
    <message>
        <source>Drawings (*.svg);;Pictures (*.png)</source>
        <translation>Zeichnungen (*.svg);;Bilder (*.png)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Plots appear during tracking.</source>
        <translation>Kurven erscheinen, sobald die Verfolgung läuft.</translation>
    </message>
    <message>
        <source>The target whose values are plotted: the target selected in the panel Target, or the first target if none is selected.</source>
        <translation>Das Ziel, dessen Werte gezeichnet werden: das im Bereich „Ziel“ gewählte, oder das erste, wenn keines gewählt ist.</translation>
    </message>
    <message>
        <source>The frame that all views show. The numbers beside the plots are the values in this frame.
In the plots, the wheel scrolls, Ctrl+wheel zooms in time at the pointer, and Shift+wheel moves along the time axis.</source>
        <translation>Das Bild, das alle Ansichten zeigen. Die Zahlen neben den Kurven sind die Werte in diesem Bild.
In den Kurven rollt das Mausrad, Strg+Mausrad zoomt die Zeitachse am Zeiger, und Umschalt+Mausrad bewegt sie.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotStack</name>
    <message>
        <source>frame %1, iteration %2, %3</source>
        <translation>Bild %1, Iteration %2, %3</translation>
    </message>
    <message>
        <source>Click: go to this frame · Ctrl+wheel: zoom</source>
        <translation>Klick: zu diesem Bild gehen · Strg+Mausrad: zoomen</translation>
    </message>
    <message>
        <source>frame %1, %2</source>
        <translation>Bild %1, %2</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointCalibrator</name>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>Add measured point</source>
        <translation>Gemessenen Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Remove measured point</source>
        <translation>Gemessenen Punkt entfernen</translation>
    </message>
    <message>
        <source>Rename measured point</source>
        <translation>Gemessenen Punkt umbenennen</translation>
    </message>
    <message>
        <source>Position of %1</source>
        <translation>Position von %1</translation>
    </message>
    <message>
        <source>Click %1 in %2</source>
        <translation>%1 in %2 anklicken</translation>
    </message>
    <message>
        <source>Remove %1 in %2</source>
        <translation>%1 in %2 entfernen</translation>
    </message>
    <message>
        <source>Compute cameras from measured points</source>
        <translation>Kameras aus gemessenen Punkten berechnen</translation>
    </message>
    <message>
        <source>%1: average error %2</source>
        <translation>%1: mittlerer Fehler %2</translation>
    </message>
    <message>
        <source>%1: no pose fits the clicked points</source>
        <translation>%1: Keine Lage passt zu den angeklickten Punkten</translation>
    </message>
    <message>
        <source>%1 (ignore this if the camera is mounted that way)</source>
        <translation>%1 (ignorieren Sie dies, wenn die Kamera so montiert ist)</translation>
    </message>
    <message>
        <source>%1. After this correction, the average error is %2</source>
        <translation>%1. Nach der Korrektur ist der mittlere Fehler %2</translation>
    </message>
    <message>
        <source>%1 does not fit the other points (%2, %3): measure or click it again</source>
        <translation>%1 passt nicht zu den anderen Punkten (%2, %3): Messen Sie ihn neu, oder klicken Sie ihn neu an</translation>
    </message>
    <message>
        <source>Largest error: %1 (%2, %3)</source>
        <translation>Größter Fehler: %1 (%2, %3)</translation>
    </message>
    <message>
        <source>Set orientation of %1</source>
        <translation>Ausrichtung von %1 setzen</translation>
    </message>
    <message>
        <source>The images of %1 are rotated and mirrored: turn them clockwise by %2 degrees, then mirror them</source>
        <translation>Die Bilder von %1 sind gedreht und gespiegelt: drehen Sie sie um %2 Grad im Uhrzeigersinn, und spiegeln Sie sie dann</translation>
    </message>
    <message>
        <source>The images of %1 are mirrored</source>
        <translation>Die Bilder von %1 sind gespiegelt</translation>
    </message>
    <message>
        <source>The images of %1 are rotated: turn them clockwise by %2 degrees</source>
        <translation>Die Bilder von %1 sind gedreht: drehen Sie sie um %2 Grad im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>%1: the focal length was kept, because computing it needs at least %2 points</source>
        <translation>%1: Die Brennweite wurde beibehalten, weil ihre Berechnung mindestens %2 Punkte braucht</translation>
    </message>
    <message>
        <source>No point has been clicked yet. Press “Click in images”, then click the selected point in the images</source>
        <translation>Noch kein Punkt wurde angeklickt. Drücken Sie „In Bildern anklicken“, und klicken Sie dann den gewählten Punkt in den Bildern an</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n point(s) clicked, but at least %2 are needed (six are better)</source>
        <translation>
            <numerusform>%1: %n Punkt angeklickt, aber mindestens %2 sind nötig (besser sechs)</numerusform>
            <numerusform>%1: %n Punkte angeklickt, aber mindestens %2 sind nötig (besser sechs)</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: all points lie on one line. Add a point away from this line</source>
        <translation>%1: Alle Punkte liegen auf einer Geraden. Fügen Sie einen Punkt neben dieser Geraden hinzu</translation>
    </message>
    <message>
        <source>%1: average error %2, but a second pose fits equally well. Add a point outside the plane of the others</source>
        <translation>%1: mittlerer Fehler %2, aber eine zweite Lage passt ebenso gut. Fügen Sie einen Punkt außerhalb der Ebene der anderen hinzu</translation>
    </message>
    <message>
        <source>Mirror the images of %1</source>
        <translation>Bilder von %1 spiegeln</translation>
    </message>
    <message>
        <source>Rotate the images of %1 clockwise by %2, and mirror them</source>
        <translation>Bilder von %1 um %2 im Uhrzeigersinn drehen und spiegeln</translation>
    </message>
    <message>
        <source>Rotate the images of %1 clockwise by %2</source>
        <translation>Bilder von %1 um %2 im Uhrzeigersinn drehen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointsTable</name>
    <message>
        <source>Measured points</source>
        <translation>Gemessene Punkte</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>x m</source>
        <translation>x m</translation>
    </message>
    <message>
        <source>y m</source>
        <translation>y m</translation>
    </message>
    <message>
        <source>z m</source>
        <translation>z m</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Add a position that you measured in the room</source>
        <translation>Eine Position hinzufügen, die Sie im Raum gemessen haben</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Click in images</source>
        <translation>In Bildern anklicken</translation>
    </message>
    <message>
        <source>Remove click</source>
        <translation>Klick entfernen</translation>
    </message>
    <message>
        <source>Compute focal lengths</source>
        <translation>Brennweiten berechnen</translation>
    </message>
    <message>
        <source>Compute cameras</source>
        <translation>Kameras berechnen</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>Rotate or mirror the images of this camera and compute its pose again</source>
        <translation>Die Bilder dieser Kamera drehen oder spiegeln und ihre Lage neu berechnen</translation>
    </message>
    <message>
        <source>Click the selected point in every image that shows it. Near a corner, the click moves exactly onto the corner; hold Alt to prevent this. Press Esc to finish.</source>
        <translation>Klicken Sie den gewählten Punkt in jedem Bild an, das ihn zeigt. Nahe einer Ecke springt der Klick genau auf die Ecke; halten Sie Alt gedrückt, um das zu verhindern. Esc beendet es.</translation>
    </message>
    <message>
        <source>Remove the click on the selected point from the image of the selected camera</source>
        <translation>Den Klick auf den gewählten Punkt aus dem Bild der gewählten Kamera entfernen</translation>
    </message>
    <message>
        <source>clicked</source>
        <translation>angeklickt</translation>
    </message>
    <message>
        <source>Remove the selected point</source>
        <translation>Den ausgewählten Punkt entfernen</translation>
    </message>
    <message>
        <source>Also compute the focal length of each camera in which you clicked six or more points. Other cameras keep their focal length</source>
        <translation>Auch die Brennweite jeder Kamera berechnen, in der Sie sechs oder mehr Punkte angeklickt haben. Andere Kameras behalten ihre Brennweite</translation>
    </message>
    <message>
        <source>Compute the poses of all cameras in which points were clicked. Each camera needs at least four points; six that do not all lie in one plane are better</source>
        <translation>Die Lagen aller Kameras berechnen, in denen Punkte angeklickt wurden. Jede Kamera braucht mindestens vier Punkte; besser sind sechs, die nicht alle in einer Ebene liegen</translation>
    </message>
    <message>
        <source>Positions measured with a tape, in meters: double-click to edit. ▲ marks a point that does not fit the others.</source>
        <translation>Mit dem Maßband gemessene Positionen, in Metern: Doppelklick zum Bearbeiten. ▲ bezeichnet einen Punkt, der nicht zu den anderen passt.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PreviewPane</name>
    <message>
        <source>Preparing the preview: %1 %</source>
        <translation>Vorschau wird erstellt: %1 %</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>Erste Zeilen der Datei</translation>
    </message>
    <message>
        <source>Units and axes</source>
        <translation>Einheiten und Achsen</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Some of these results were tracked with earlier settings.</source>
        <translation>Einige dieser Ergebnisse entstanden mit früheren Einstellungen.</translation>
    </message>
    <message>
        <source>The preview was stopped. It starts again when you change a setting.</source>
        <translation>Die Vorschau wurde angehalten. Sie beginnt von vorn, wenn Sie eine Einstellung ändern.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProblemReport</name>
    <message>
        <source>Report a problem – Dewpoint</source>
        <translation>Problem melden – Dewpoint</translation>
    </message>
    <message>
        <source>Text for the report</source>
        <translation>Text für die Meldung</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the text so that you can paste it into an email or a form</source>
        <translation>Den Text kopieren, um ihn in eine E-Mail oder ein Formular einzufügen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Run self-test</source>
        <translation>Selbsttest ausführen</translation>
    </message>
    <message>
        <source>Stop the self-test</source>
        <translation>Den Selbsttest abbrechen</translation>
    </message>
    <message>
        <source>Test graphics, codecs, cameras and disk, and track a simulated scene for a few seconds</source>
        <translation>Grafik, Codecs, Kameras und Laufwerk testen und einige Sekunden lang eine simulierte Szene verfolgen</translation>
    </message>
    <message>
        <source>Write to whoever gave you Dewpoint. Describe what you did, what you expected and what happened. Run the self-test. Attach the text below and, if you can, the project file and a screenshot. Nothing is sent automatically.</source>
        <translation>Schreiben Sie an die Stelle, von der Sie Dewpoint haben. Beschreiben Sie, was Sie getan haben, was Sie erwartet haben und was geschah. Führen Sie den Selbsttest aus. Fügen Sie den Text unten an und, wenn möglich, die Projektdatei und ein Bildschirmfoto. Nichts wird automatisch gesendet.</translation>
    </message>
    <message>
        <source>Progress of the self-test</source>
        <translation>Fortschritt des Selbsttests</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectCheckDialog</name>
    <message>
        <source>Checking recordings, times, calibration, colors and method…</source>
        <translation>Prüfe Aufnahmen, Zeiten, Kalibrierung, Farben und Verfahren…</translation>
    </message>
    <message>
        <source>The check was canceled.</source>
        <translation>Die Prüfung wurde abgebrochen.</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) must be solved before this project can be tracked.</source>
        <translation>
            <numerusform>Bevor mit diesem Projekt verfolgt werden kann, muss %n Problem gelöst werden.</numerusform>
            <numerusform>Bevor mit diesem Projekt verfolgt werden kann, müssen %n Probleme gelöst werden.</numerusform>
        </translation>
    </message>
    <message>
        <source>No problems, but look at the points marked ◆.</source>
        <translation>Keine Probleme. Die mit ◆ markierten Punkte sind vielleicht nicht so, wie Sie es wollen.</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>Keine Probleme.</translation>
    </message>
    <message>
        <source>Check project – Dewpoint</source>
        <translation>Projekt prüfen – Dewpoint</translation>
    </message>
    <message>
        <source>Result of the check</source>
        <translation>Ergebnis der Prüfung</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>Fortschritt der Prüfung</translation>
    </message>
    <message>
        <source>Read every frame</source>
        <translation>Jedes Bild lesen</translation>
    </message>
    <message>
        <source>Find damaged frames anywhere in a recording: all frames are read, not only a few of them. This takes longer</source>
        <translation>Beschädigte Bilder überall in einer Aufnahme finden: Alle Bilder werden gelesen, nicht nur einige. Das dauert länger</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Erneut prüfen</translation>
    </message>
    <message>
        <source>Check the project as it is now</source>
        <translation>Das Projekt prüfen, wie es jetzt ist</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop the check</source>
        <translation>Die Prüfung abbrechen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the result as English text, for example for a bug report</source>
        <translation>Das Ergebnis als englischen Text kopieren, zum Beispiel für einen Fehlerbericht</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectController</name>
    <message>
        <source>Click the object or drag a box around it in any camera view.</source>
        <translation>Klicken Sie das Objekt in einer Kameraansicht an, oder ziehen Sie einen Rahmen darum.</translation>
    </message>
    <message>
        <source>Click the object to track in any image. Its color is learned and tracking starts.</source>
        <translation>Klicken Sie in einem Bild das Objekt an, das verfolgt werden soll. Seine Farbe wird gelernt, und die Verfolgung beginnt.</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Ein Projekt öffnen</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml);;All files (*)</source>
        <translation>Dewpoint-Projekte (*.toml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The changes were recovered. Save the project to keep them.</source>
        <translation>Die Änderungen wurden wiederhergestellt. Speichern Sie das Projekt, um sie zu behalten.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectPane</name>
    <message>
        <source>Cameras of the project</source>
        <translation>Kameras des Projekts</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Exchange with</source>
        <translation>Vertauschen mit</translation>
    </message>
    <message>
        <source>Exchange the image source with that of another camera, for example after the cables were exchanged. The cameras keep their names and calibrations</source>
        <translation>Die Bildquelle mit der einer anderen Kamera vertauschen, zum Beispiel nachdem die Kabel vertauscht wurden. Die Kameras behalten ihre Namen und Kalibrierungen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the camera, in views and files</source>
        <translation>Name der Kamera, in Ansichten und Dateien</translation>
    </message>
    <message>
        <source>Rotated</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>Clockwise rotation of the images before use. The calibration is rotated with them</source>
        <translation>Drehung der Bilder im Uhrzeigersinn vor der Verwendung. Die Kalibrierung wird mit ihnen gedreht</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Mirror the images left to right, after rotation</source>
        <translation>Die Bilder nach dem Drehen seitenverkehrt spiegeln</translation>
    </message>
    <message>
        <source>Lock colors</source>
        <translation>Farben sperren</translation>
    </message>
    <message>
        <source>Switch off the automatic exposure, gain and white balance of this camera, and keep the current values</source>
        <translation>Belichtung, Verstärkung und Weißabgleich dieser Kamera nicht mehr automatisch regeln und die jetzigen Werte behalten</translation>
    </message>
    <message>
        <source>Lock all cameras</source>
        <translation>Alle Kameras sperren</translation>
    </message>
    <message>
        <source>Switch off the automatic exposure, gain and white balance of all connected cameras, and keep the current values</source>
        <translation>Belichtung, Verstärkung und Weißabgleich aller angeschlossenen Kameras nicht mehr automatisch regeln und die jetzigen Werte behalten</translation>
    </message>
    <message>
        <source>Remove this camera. Undo restores it with its calibration</source>
        <translation>Diese Kamera entfernen. Rückgängig stellt sie mit ihrer Kalibrierung wieder her</translation>
    </message>
    <message>
        <source>A project needs at least one camera</source>
        <translation>Ein Projekt braucht mindestens eine Kamera</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
    <message>
        <source>A simulated scene has its own cameras. They cannot be changed.</source>
        <translation>Eine simulierte Szene hat eigene Kameras. Sie können nicht geändert werden.</translation>
    </message>
    <message>
        <source>▲ Several devices may be this camera. Choose one on the right.</source>
        <translation>▲ Mehrere Geräte könnten diese Kamera sein. Wählen Sie rechts eines aus.</translation>
    </message>
    <message>
        <source>▲ This device is not connected.</source>
        <translation>▲ Dieses Gerät ist nicht angeschlossen.</translation>
    </message>
    <message>
        <source>This camera is not calibrated yet.</source>
        <translation>Diese Kamera ist noch nicht kalibriert.</translation>
    </message>
    <message>
        <source>▲ The calibration is for images of %1. Choose this size, or calibrate again.</source>
        <translation>▲ Die Kalibrierung gilt für Bilder von %1. Wählen Sie diese Größe oder kalibrieren Sie erneut.</translation>
    </message>
    <message>
        <source>Cropped</source>
        <translation>Zugeschnitten</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::QuickStart</name>
    <message>
        <source>The cameras confirm where the target is.</source>
        <translation>Die Kameras bestätigen, wo das Ziel ist.</translation>
    </message>
    <message>
        <source>Another object fits about as well. Press X and drag the target to its true position.</source>
        <translation>Ein anderes Objekt passt etwa genauso gut. Drücken Sie X, und ziehen Sie das Ziel an seine wahre Position.</translation>
    </message>
    <message>
        <source>The target is not found yet, or has been out of sight for less than a second.</source>
        <translation>Das Ziel ist noch nicht gefunden oder seit weniger als einer Sekunde nicht zu sehen.</translation>
    </message>
    <message>
        <source>The target has been out of sight for more than a second. The status bar shows why.</source>
        <translation>Das Ziel ist seit mehr als einer Sekunde nicht zu sehen. Die Statusleiste zeigt, warum.</translation>
    </message>
    <message>
        <source>Quick start – Dewpoint</source>
        <translation>Schnelleinstieg – Dewpoint</translation>
    </message>
    <message>
        <source>What you see</source>
        <translation>Was Sie sehen</translation>
    </message>
    <message>
        <source>Each camera view shows its image with the estimates drawn over it. The bird&apos;s-eye view shows the estimates in the room.</source>
        <translation>Jede Kameraansicht zeigt ihr Bild und darüber die Schätzungen. Die Vogelperspektive zeigt die Schätzungen im Raum.</translation>
    </message>
    <message>
        <source>State of a target</source>
        <translation>Zustand eines Ziels</translation>
    </message>
    <message>
        <source>How to start</source>
        <translation>Wie Sie beginnen</translation>
    </message>
    <message>
        <source>1.  Open one video per camera, or connect cameras: File › New project (%1). Or try the demo first.</source>
        <translation>1.  Öffnen Sie ein Video je Kamera, oder schließen Sie Kameras an: Datei › Neues Projekt (%1). Oder probieren Sie zuerst die Demo aus.</translation>
    </message>
    <message>
        <source>3.  Click the object to track in any image. Its color is learned in all cameras, and tracking starts.</source>
        <translation>3.  Klicken Sie in einem Bild das Objekt an, das verfolgt werden soll. Seine Farbe wird in allen Kameras gelernt, und die Verfolgung beginnt.</translation>
    </message>
    <message>
        <source>4.  Press %1 to play or pause. Drag along the timeline to look back: all views then show that frame as it was tracked.</source>
        <translation>4.  %1 spielt ab und hält an. Ziehen Sie auf der Zeitleiste, um zurückzublicken: Alle Ansichten zeigen dann dieses Bild, wie es verfolgt wurde.</translation>
    </message>
    <message>
        <source>5.  Export the trajectory: File › Export trajectory (%1).</source>
        <translation>5.  Exportieren Sie die Bahn: Datei › Bahn exportieren (%1).</translation>
    </message>
    <message>
        <source>Show legend…</source>
        <translation>Legende zeigen…</translation>
    </message>
    <message>
        <source>Open the legend of everything drawn over the images</source>
        <translation>Die Legende von allem öffnen, was über die Bilder gezeichnet wird</translation>
    </message>
    <message>
        <source>Manual…</source>
        <translation>Handbuch…</translation>
    </message>
    <message>
        <source>Open the manual</source>
        <translation>Das Handbuch öffnen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Dieses Fenster schließen</translation>
    </message>
    <message>
        <source>2.  Calibrate the cameras: Calibration › Calibrate (%1) guides you through it. Without a calibration, targets are tracked only in the images.</source>
        <translation>2.  Kalibrieren Sie die Kameras: Kalibrierung › Kalibrieren (%1) führt Sie hindurch. Ohne Kalibrierung werden Ziele nur in den Bildern verfolgt.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentList</name>
    <message>
        <source>The file no longer exists</source>
        <translation>Die Datei ist nicht mehr da</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentMenu</name>
    <message>
        <source>No recent projects</source>
        <translation>Keine zuletzt geöffneten Projekte</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>Liste leeren</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecoveryOffer</name>
    <message>
        <source>Dewpoint closed unexpectedly. Unsaved changes to “%1” from %2 can be recovered.</source>
        <translation>Dewpoint wurde unerwartet beendet. Ungespeicherte Änderungen an „%1“ von %2 lassen sich wiederherstellen.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Unsaved changes to “%1” were discarded.</source>
        <translation>Ungespeicherte Änderungen an „%1“ wurden verworfen.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RigPlanner</name>
    <message>
        <source>With %1 at x %2, y %3, z %4, the error is at most %6 in %5 of the volume (in %7 without this camera).</source>
        <translation>Mit %1 an der Stelle x %2, y %3, z %4 ist der Fehler in %5 des Raums höchstens %6 (in %7 ohne diese Kamera).</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RoomDisplay</name>
    <message>
        <source>What to show next – Dewpoint</source>
        <translation>Was als Nächstes zu zeigen ist – Dewpoint</translation>
    </message>
    <message>
        <source>Time for which the board was held still</source>
        <translation>Zeit, die die Tafel stillgehalten wurde</translation>
    </message>
    <message numerus="yes">
        <source>%n views captured</source>
        <translation>
            <numerusform>%n Ansicht aufgenommen</numerusform>
            <numerusform>%n Ansichten aufgenommen</numerusform>
        </translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Erledigt.</translation>
    </message>
    <message>
        <source>Press Start on the page Board.</source>
        <translation>Drücken Sie Beginnen auf der Seite Tafel.</translation>
    </message>
    <message>
        <source>Waiting for images…</source>
        <translation>Warten auf Bilder…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunAlerts</name>
    <message>
        <source>No camera has moved.</source>
        <translation>Keine Kamera hat sich bewegt.</translation>
    </message>
    <message>
        <source>The pose of %1 cannot be recomputed now.</source>
        <translation>Die Lage von %1 lässt sich jetzt nicht neu berechnen.</translation>
    </message>
    <message>
        <source>Recompute pose of %1</source>
        <translation>Lage von %1 neu berechnen</translation>
    </message>
    <message>
        <source>The pose of %1 was recomputed. Undo restores the previous pose.</source>
        <translation>Die Lage von %1 wurde neu berechnet. „Rückgängig“ stellt die vorige Lage wieder her.</translation>
    </message>
    <message>
        <source>Disagreement with the other cameras: %1 before, %2 now.</source>
        <translation>Abweichung von den anderen Kameras: vorher %1, jetzt %2.</translation>
    </message>
    <message>
        <source>Done: %1. You can undo this.</source>
        <translation>Erledigt: %1. Sie können es rückgängig machen.</translation>
    </message>
    <message>
        <source>No longer applies: %1</source>
        <translation>Gilt nicht mehr: %1</translation>
    </message>
    <message numerus="yes">
        <source>◆ %n notice(s)</source>
        <translation>
            <numerusform>◆ %n Hinweis</numerusform>
            <numerusform>◆ %n Hinweise</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the hidden notices</source>
        <translation>Die ausgeblendeten Hinweise zeigen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunDetails</name>
    <message>
        <source>median %1, 99 % at most %2, longest %3</source>
        <translation>Median %1, 99 % höchstens %2, längste %3</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>nicht festgelegt</translation>
    </message>
    <message>
        <source>%1 (met by %2 % of the iterations of this run)</source>
        <translation>%1 (von %2 % der Iterationen dieses Laufs eingehalten)</translation>
    </message>
    <message>
        <source>Median time per iteration</source>
        <translation>Mediane Zeit pro Iteration</translation>
    </message>
    <message>
        <source>Time from camera image to estimate</source>
        <translation>Zeit vom Kamerabild zur Schätzung</translation>
    </message>
    <message>
        <source>Time budget per iteration</source>
        <translation>Zeitbudget pro Iteration</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>Effektive Stichprobengröße</translation>
    </message>
    <message>
        <source>Iterations since the start</source>
        <translation>Iterationen seit dem Start</translation>
    </message>
    <message>
        <source>Frames skipped</source>
        <translation>Übersprungene Bilder</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>%1 of %2 particles</source>
        <translation>%1 von %2 Partikeln</translation>
    </message>
    <message>
        <source>%1 of %2 MB</source>
        <translation>%1 von %2 MB</translation>
    </message>
    <message>
        <source>median %1, 99th percentile %2</source>
        <translation>Median %1, 99. Perzentil %2</translation>
    </message>
    <message>
        <source>Median: capture %1 · decode %2 · wait %3 · compute %4 · draw %5</source>
        <translation>Median: Aufnahme %1 · Dekodieren %2 · Warten %3 · Rechnen %4 · Zeichnen %5</translation>
    </message>
    <message>
        <source>If a camera does not report capture times, the time is counted from the arrival of its image</source>
        <translation>Meldet eine Kamera keine Aufnahmezeiten, wird die Zeit ab der Ankunft ihres Bildes gezählt</translation>
    </message>
    <message>
        <source>Time from light to estimate</source>
        <translation>Zeit vom Licht bis zur Schätzung</translation>
    </message>
    <message>
        <source>Memory for earlier frames</source>
        <translation>Speicher für frühere Bilder</translation>
    </message>
    <message>
        <source>Memory for going back to earlier frames: images, particles and saved states of the method. When it is full, only the estimates of older frames are kept.</source>
        <translation>Speicher für den Rückblick auf frühere Bilder: Bilder, Partikel und gespeicherte Zustände des Verfahrens. Ist er voll, bleiben von älteren Bildern nur die Schätzungen.</translation>
    </message>
    <message>
        <source>99th percentile: capture %1 · decode %2 · wait %3 · compute %4 · draw %5</source>
        <translation>99. Perzentil: Aufnahme %1 · Dekodieren %2 · Warten %3 · Rechnen %4 · Zeichnen %5</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SessionController</name>
    <message>
        <source>Restart the run? The results so far will be lost.</source>
        <translation>Den Lauf neu beginnen? Die bisherigen Ergebnisse gehen verloren.</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Use image size of the cameras</source>
        <translation>Bildgröße der Kameras übernehmen</translation>
    </message>
    <message>
        <source>The recording has ended. Track it again from the beginning? The results so far will be lost.</source>
        <translation>Die Aufnahme ist zu Ende. Noch einmal von vorn verfolgen? Die bisherigen Ergebnisse gehen verloren.</translation>
    </message>
    <message>
        <source>Track from the beginning</source>
        <translation>Von vorn verfolgen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ShortcutEditor</name>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Aktionen suchen</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Actions and their shortcuts</source>
        <translation>Aktionen und ihre Tastenkürzel</translation>
    </message>
    <message>
        <source>Click here and press the new keys of the chosen action</source>
        <translation>Hier klicken und die neuen Tasten der gewählten Aktion drücken</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Neues Tastenkürzel</translation>
    </message>
    <message>
        <source>No shortcut</source>
        <translation>Kein Tastenkürzel</translation>
    </message>
    <message>
        <source>Remove the shortcut of the selected action</source>
        <translation>Das Tastenkürzel der gewählten Aktion entfernen</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all shortcuts to their defaults</source>
        <translation>Alle Tastenkürzel auf ihre Vorgaben zurücksetzen</translation>
    </message>
    <message>
        <source>Choose an action, click the field below and press the new keys.</source>
        <translation>Eine Aktion wählen, in das Feld unten klicken und die neuen Tasten drücken.</translation>
    </message>
    <message>
        <source>“%1” no longer has a shortcut.</source>
        <translation>„%1“ hat kein Tastenkürzel mehr.</translation>
    </message>
    <message>
        <source>All shortcuts were reset to their defaults.</source>
        <translation>Alle Tastenkürzel wurden auf ihre Vorgaben zurückgesetzt.</translation>
    </message>
    <message>
        <source>“%1” now has the shortcut %2.</source>
        <translation>„%1“ hat jetzt das Tastenkürzel %2.</translation>
    </message>
    <message>
        <source>“%1” now has the shortcut %2, which was removed from “%3”.</source>
        <translation>„%1“ hat jetzt das Tastenkürzel %2, das bei „%3“ entfernt wurde.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close; changed shortcuts are already saved</source>
        <translation>Schließen; geänderte Kürzel sind schon gespeichert</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SourcePane</name>
    <message>
        <source>Connected to this computer</source>
        <translation>An diesem Computer angeschlossen</translation>
    </message>
    <message>
        <source>No camera is connected. Plug one in: it appears here by itself.</source>
        <translation>Keine Kamera ist angeschlossen. Schließen Sie eine an: Sie erscheint hier von selbst.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Assign to selected camera</source>
        <translation>Ausgewählter Kamera zuweisen</translation>
    </message>
    <message>
        <source>Network cameras, pipelines and test patterns</source>
        <translation>Netzwerkkameras, Pipelines und Testbilder</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Add videos…</source>
        <translation>Videos hinzufügen…</translation>
    </message>
    <message>
        <source>Add image folder…</source>
        <translation>Bilderordner hinzufügen…</translation>
    </message>
    <message>
        <source>A simulated scene has its own cameras. They cannot be changed.</source>
        <translation>Eine simulierte Szene hat eigene Kameras. Sie können nicht geändert werden.</translation>
    </message>
    <message>
        <source>This project has live cameras. Recordings need a project of their own.</source>
        <translation>Dieses Projekt hat Live-Kameras. Aufnahmen brauchen ein eigenes Projekt.</translation>
    </message>
    <message>
        <source>This project has recordings. Live cameras need a project of their own.</source>
        <translation>Dieses Projekt hat Aufnahmen. Live-Kameras brauchen ein eigenes Projekt.</translation>
    </message>
    <message>
        <source>used by %1</source>
        <translation>von %1 verwendet</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>The project uses this device already</source>
        <translation>Das Projekt verwendet dieses Gerät bereits</translation>
    </message>
    <message>
        <source>Add the device as a new camera of the project</source>
        <translation>Das Gerät als neue Kamera zum Projekt hinzufügen</translation>
    </message>
    <message>
        <source>Exchange the devices of this camera and of the selected camera</source>
        <translation>Die Geräte dieser und der ausgewählten Kamera vertauschen</translation>
    </message>
    <message>
        <source>Make this device the image source of the selected camera. The camera keeps its name and its calibration</source>
        <translation>Dieses Gerät zur Bildquelle der ausgewählten Kamera machen. Die Kamera behält Namen und Kalibrierung</translation>
    </message>
    <message>
        <source>Video files, one per camera</source>
        <translation>Videodateien, eine je Kamera</translation>
    </message>
    <message>
        <source>A folder of images, one per frame</source>
        <translation>Ein Ordner mit Bildern, eines je Zeitpunkt</translation>
    </message>
    <message>
        <source>Choose one video per camera</source>
        <translation>Ein Video je Kamera wählen</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)</source>
        <translation>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Einen Ordner mit Bildern wählen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SpeedButton</name>
    <message>
        <source>1/%1 ×</source>
        <comment>speed</comment>
        <translation>1/%1 ×</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <comment>speed</comment>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Playback speed of the recording. Live cameras are always tracked in real time.</source>
        <translation>Wiedergabegeschwindigkeit der Aufnahme. Livekameras werden immer in Echtzeit verfolgt.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StartPage</name>
    <message>
        <source>Dewpoint</source>
        <translation>Dewpoint</translation>
    </message>
    <message>
        <source>Try the demo</source>
        <translation>Demo ausprobieren</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Zuletzt geöffnete Projekte</translation>
    </message>
    <message>
        <source>You can also drop a project or videos onto this window.</source>
        <translation>Ein Projekt oder Videos lassen sich auch auf dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>Watch the filter converge</source>
        <translation>Zusehen, wie der Filter konvergiert</translation>
    </message>
    <message>
        <source>A cloud of guesses slides along a line of sight and snaps onto the ball.</source>
        <translation>Eine Wolke von Vermutungen gleitet eine Sichtlinie entlang und springt auf den Ball.</translation>
    </message>
    <message>
        <source>Hidden for a second</source>
        <translation>Eine Sekunde lang verdeckt</translation>
    </message>
    <message>
        <source>People in an office</source>
        <translation>Personen in einem Büro</translation>
    </message>
    <message>
        <source>Four cameras find everyone in 3D and give each person a number.</source>
        <translation>Vier Kameras finden jede Person in 3D und geben ihr eine Nummer.</translation>
    </message>
    <message>
        <source>One camera, target in a box</source>
        <translation>Eine Kamera, Ziel im Rahmen</translation>
    </message>
    <message>
        <source>Needs no calibration: the target is marked with a rectangle and tracked by its colors.</source>
        <translation>Braucht keine Kalibrierung: Das Ziel wird mit einem Rahmen markiert und anhand seiner Farben verfolgt.</translation>
    </message>
    <message>
        <source>Calibrate by hand</source>
        <translation>Von Hand kalibrieren</translation>
    </message>
    <message>
        <source>Drag a grid over the images until it matches the floor.</source>
        <translation>Ein Gitter über die Bilder ziehen, bis es zum Boden passt.</translation>
    </message>
    <message>
        <source>Follow colored objects in 3D with ordinary cameras.</source>
        <translation>Farbige Objekte mit gewöhnlichen Kameras in 3D verfolgen.</translation>
    </message>
    <message>
        <source>Two simulated cameras see a pink ball; a particle filter finds it and follows it through space. Pause, go back, change anything: you cannot break it.</source>
        <translation>Zwei simulierte Kameras sehen einen rosa Ball; ein Partikelfilter findet ihn und verfolgt ihn durch den Raum. Anhalten, zurückblicken, alles ändern: Nichts kann kaputtgehen.</translation>
    </message>
    <message>
        <source>Your own data</source>
        <translation>Eigene Daten</translation>
    </message>
    <message>
        <source>Open videos…</source>
        <translation>Videos öffnen…</translation>
    </message>
    <message>
        <source>One recording per camera</source>
        <translation>Eine Aufnahme je Kamera</translation>
    </message>
    <message>
        <source>Use cameras…</source>
        <translation>Kameras verwenden…</translation>
    </message>
    <message>
        <source>Connected cameras or network streams</source>
        <translation>Angeschlossene Kameras oder Netzwerkströme</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>Projekt öffnen…</translation>
    </message>
    <message>
        <source>A project saved earlier</source>
        <translation>Ein früher gespeichertes Projekt</translation>
    </message>
    <message>
        <source>A box passes in front of the ball. One camera is enough to keep tracking the ball.</source>
        <translation>Eine Kiste zieht vor dem Ball vorbei. Eine Kamera genügt, um den Ball weiter zu verfolgen.</translation>
    </message>
    <message>
        <source>Calibrate cameras…</source>
        <translation>Kameras kalibrieren …</translation>
    </message>
    <message>
        <source>From videos of a board or a ball, step by step</source>
        <translation>Mit Videos einer Tafel oder eines Balls, Schritt für Schritt</translation>
    </message>
    <message>
        <source>Identical balls</source>
        <translation>Gleiche Bälle</translation>
    </message>
    <message>
        <source>Other balls have the same color, but only one ball moves.</source>
        <translation>Andere Bälle haben dieselbe Farbe, aber nur ein Ball bewegt sich.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StatusBarPanel</name>
    <message>
        <source>playing</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>am Ende</translation>
    </message>
    <message>
        <source>Estimated position of the target in the room</source>
        <translation>Geschätzte Position des Ziels im Raum</translation>
    </message>
    <message>
        <source>frame %1 / %2</source>
        <translation>Bild %1 / %2</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3</source>
        <translation>x %1  y %2  z %3</translation>
    </message>
    <message>
        <source>tracking again</source>
        <translation>verfolgt erneut</translation>
    </message>
    <message>
        <source>looking back</source>
        <translation>Rückblick</translation>
    </message>
    <message>
        <source>State of the run: playing, paused, at the end, looking back at an earlier frame, or tracking again</source>
        <translation>Zustand des Laufs: läuft, angehalten, am Ende, im Rückblick auf ein früheres Bild oder erneut verfolgend</translation>
    </message>
    <message>
        <source>the box shows the expected position</source>
        <translation>der Rahmen zeigt die erwartete Position</translation>
    </message>
    <message>
        <source>click the object or drag a box around it</source>
        <translation>Objekt anklicken oder einen Rahmen darum ziehen</translation>
    </message>
    <message>
        <source>x %1  y %2  %3 × %4</source>
        <translation>x %1  y %2  %3 × %4</translation>
    </message>
    <message>
        <source>● people: %1</source>
        <translation>● Personen: %1</translation>
    </message>
    <message>
        <source>○ people: %1, searching</source>
        <translation>○ Personen: %1, sucht</translation>
    </message>
    <message>
        <source>other objects fit equally well: press X and drag the target to its position</source>
        <translation>andere Objekte passen ebenso gut: X drücken und das Ziel an seine Position ziehen</translation>
    </message>
    <message>
        <source>± %1</source>
        <translation>± %1</translation>
    </message>
    <message>
        <source>Speed of the target in the room</source>
        <translation>Geschwindigkeit des Ziels im Raum</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Timing, particles and memory used</source>
        <translation>Zeiten, Partikel und benutzter Speicher</translation>
    </message>
    <message>
        <source>Tracking: the cameras confirm the estimate. Ambiguous: another object fits about as well. Lost: not tracked for more than a second.</source>
        <translation>Verfolgt: Die Kameras bestätigen die Schätzung. Mehrdeutig: Ein anderes Objekt passt etwa genauso gut. Verloren: seit mehr als einer Sekunde nicht verfolgt.</translation>
    </message>
    <message>
        <source>Uncertainty of the position: the standard deviations in x, y and z combined. The plots show each of the three</source>
        <translation>Unsicherheit der Position: die Standardabweichungen in x, y und z zusammen. Die Kurven zeigen jede der drei</translation>
    </message>
    <message>
        <source>Number of the frame shown, and number of all frames. Click to go to another frame</source>
        <translation>Nummer des gezeigten Bildes und Anzahl aller Bilder. Klicken, um zu einem anderen Bild zu gehen</translation>
    </message>
    <message>
        <source>Frames tracked per second, while playing</source>
        <translation>Verfolgte Bilder je Sekunde, während der Wiedergabe</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StepStrip</name>
    <message>
        <source>Step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>Step %1: %2. %3</source>
        <translation>Schritt %1: %2. %3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TakeComparison</name>
    <message>
        <source>This take contains the results of the live run.</source>
        <translation>Diese Aufnahme enthält die Ergebnisse des Live-Laufs.</translation>
    </message>
    <message>
        <source>Compare results</source>
        <translation>Ergebnisse vergleichen</translation>
    </message>
    <message>
        <source>Tracking the take again…</source>
        <translation>Die Aufnahme wird noch einmal verfolgt …</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TakeController</name>
    <message>
        <source>The recording ended, because its cameras were closed.</source>
        <translation>Die Aufnahme wurde beendet, weil ihre Kameras geschlossen wurden.</translation>
    </message>
    <message>
        <source>Take %1 (%2) was saved in %3.</source>
        <translation>Aufnahme %1 (%2) wurde in %3 gespeichert.</translation>
    </message>
    <message>
        <source>Problem: %1</source>
        <translation>Problem: %1</translation>
    </message>
    <message>
        <source>Open take</source>
        <translation>Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Ordner zeigen</translation>
    </message>
    <message>
        <source>Notes…</source>
        <translation>Notizen …</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TakeDialog</name>
    <message>
        <source>Take %1</source>
        <translation>Aufnahme %1</translation>
    </message>
    <message>
        <source>Next take</source>
        <translation>Nächste Aufnahme</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>next free number</source>
        <translation>nächste freie Nummer</translation>
    </message>
    <message>
        <source>Number of the take and of its folder. The number increases by itself with each take.</source>
        <translation>Nummer der Aufnahme und ihres Ordners. Die Nummer erhöht sich mit jeder Aufnahme von selbst.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Pre-roll</source>
        <translation>Vorlauf</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>How many seconds before the start are recorded as well. For this, the last images of all cameras are kept in memory, up to 512 MB in total.</source>
        <translation>Zeit vor dem Start, die mit aufgenommen wird. Dafür bleiben die letzten Bilder aller Kameras im Speicher, zusammen bis zu 512 MB.</translation>
    </message>
    <message>
        <source>Text that is saved with the take</source>
        <translation>Text, der mit der Aufnahme gespeichert wird</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TargetPanel</name>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Target name, as shown in views and files</source>
        <translation>Name des Ziels, in Ansichten und Dateien</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Radius of the ball, 0 to 2,000 mm. If unknown, it is estimated.</source>
        <translation>Radius des Balls, 0 bis 2.000 mm. Ist er unbekannt, wird er geschätzt.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>Ball</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>No target yet. In any camera image, click the object to track.</source>
        <translation>Noch kein Ziel: Klicken Sie in einem Kamerabild das Objekt an, das verfolgt werden soll.</translation>
    </message>
    <message>
        <source>Rename target</source>
        <translation>Ziel umbenennen</translation>
    </message>
    <message>
        <source>Change radius</source>
        <translation>Radius ändern</translation>
    </message>
    <message>
        <source>Change shape</source>
        <translation>Form ändern</translation>
    </message>
    <message>
        <source>Remove target</source>
        <translation>Ziel entfernen</translation>
    </message>
    <message>
        <source>Click the object or drag a box around it in any camera view. It is tracked from there.</source>
        <translation>Klicken Sie das Objekt in einer Kameraansicht an, oder ziehen Sie einen Rahmen darum. Von da an wird es verfolgt.</translation>
    </message>
    <message>
        <source>No box in this frame.</source>
        <translation>In diesem Bild kein Rahmen.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>Radius %1</translation>
    </message>
    <message>
        <source>radius %1 (estimated)</source>
        <translation>Radius %1 (geschätzt)</translation>
    </message>
    <message>
        <source>radius unknown</source>
        <translation>Radius unbekannt</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Add target</source>
        <translation>Ziel hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Ball: the outline of the target is a circle in every image. Any: the size of the target is learned, and its position is the center of the region that has its color. Automatic: the shape is determined from the images. Only method dewpoint uses this setting.</source>
        <translation>Ball: Der Umriss des Ziels ist in jedem Bild ein Kreis. Beliebig: Die Größe des Ziels wird gelernt, und seine Position ist die Mitte des Bereichs, der seine Farbe hat. Automatisch: Die Form wird aus den Bildern bestimmt. Nur das Verfahren dewpoint verwendet diese Einstellung.</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>Radius (mm)</translation>
    </message>
    <message>
        <source>To learn the color of this target, press Learn and click the target in a camera image.</source>
        <translation>Um die Farbe dieses Ziels zu lernen, drücken Sie „Lernen“ und klicken Sie das Ziel in einem Kamerabild an.</translation>
    </message>
    <message>
        <source>Hide target</source>
        <translation>Ziel ausblenden</translation>
    </message>
    <message>
        <source>Show target</source>
        <translation>Ziel einblenden</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TargetRowDelegate</name>
    <message>
        <source>Hide this target in the images and in the bird&apos;s-eye view. It is still tracked.</source>
        <translation>Dieses Ziel in den Bildern und in der Vogelperspektive ausblenden. Es wird weiter verfolgt.</translation>
    </message>
    <message>
        <source>Show this target in the images and in the bird&apos;s-eye view</source>
        <translation>Dieses Ziel in den Bildern und in der Vogelperspektive einblenden</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ThreadCountDialog</name>
    <message>
        <source>Filter threads</source>
        <translation>Filter-Threads</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Number of threads that compute the filter. The results do not depend on it</source>
        <translation>Zahl der Threads, die den Filter berechnen. Die Ergebnisse hängen nicht davon ab</translation>
    </message>
    <message>
        <source>The new number is used from the next frame on.</source>
        <translation>Die neue Anzahl gilt ab dem nächsten Bild.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Use this number</source>
        <translation>Diese Anzahl übernehmen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close and keep the current number</source>
        <translation>Schließen und die aktuelle Anzahl behalten</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Timeline</name>
    <message>
        <source>Nothing tracked yet: press play (Space), then drag here to move through time.</source>
        <translation>Noch nichts verfolgt: abspielen (Leertaste), dann hier durch die Zeit ziehen.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>The change applies to new frames. Use “%1” to track again from the current frame.</source>
        <translation>Die Änderung gilt für neue Bilder. Mit „%1“ verfolgen Sie ab dem aktuellen Bild erneut.</translation>
    </message>
    <message>
        <source>After this frame, there are no new problems with targets or cameras.</source>
        <translation>Nach diesem Bild gibt es keine neuen Störungen bei Zielen oder Kameras.</translation>
    </message>
    <message>
        <source>Before this frame, there are no other problems with targets or cameras.</source>
        <translation>Vor diesem Bild gibt es keine anderen Störungen bei Zielen oder Kameras.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TouchedInstantList</name>
    <message>
        <source>What the ball does at this time</source>
        <translation>Was der Ball zu diesem Zeitpunkt tut</translation>
    </message>
    <message>
        <source>Add current time</source>
        <translation>Aktuelle Zeit hinzufügen</translation>
    </message>
    <message>
        <source>Remove time</source>
        <translation>Zeit entfernen</translation>
    </message>
    <message>
        <source>Remove the selected time from the list</source>
        <translation>Den gewählten Zeitpunkt aus der Liste entfernen</translation>
    </message>
    <message>
        <source>Added times</source>
        <translation>Hinzugefügte Zeitpunkte</translation>
    </message>
    <message>
        <source>Double-click or press Enter to show the images of this time</source>
        <translation>Doppelklick oder Eingabe zeigt die Bilder dieses Zeitpunkts</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>The upward direction is computed from three positions at which the ball touches the floor, or from a fall of the ball</source>
        <translation>Die Richtung nach oben wird aus drei Positionen berechnet, an denen der Ball den Boden berührt, oder aus einem Fall des Balls</translation>
    </message>
    <message>
        <source>Add the time of the images shown to the list. In these images, the ball must do what you selected</source>
        <translation>Die Zeit der gezeigten Bilder zur Liste hinzufügen. In diesen Bildern muss der Ball tun, was Sie gewählt haben</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryModel</name>
    <message>
        <source>time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Time of the frame, in seconds</source>
        <translation>Zeit des Bildes, in Sekunden</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>Bild, ab 1 gezählt</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>Name des Ziels</translation>
    </message>
    <message>
        <source>%1, m</source>
        <translation>%1, m</translation>
    </message>
    <message>
        <source>Position in the room, in meters</source>
        <translation>Position im Raum, in Metern</translation>
    </message>
    <message>
        <source>σ%1, mm</source>
        <translation>σ%1, mm</translation>
    </message>
    <message>
        <source>Standard deviation of the position, in millimeters</source>
        <translation>Standardabweichung der Position, in Millimetern</translation>
    </message>
    <message>
        <source>speed, m/s</source>
        <translation>Geschw., m/s</translation>
    </message>
    <message>
        <source>Speed in meters per second, computed from five frames</source>
        <translation>Geschwindigkeit in Metern pro Sekunde, berechnet aus fünf Bildern</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>existence</source>
        <translation>Existenz</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>◆ corrected</source>
        <translation>◆ korrigiert</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ mehrdeutig</translation>
    </message>
    <message>
        <source>● tracking</source>
        <translation>● verfolgt</translation>
    </message>
    <message>
        <source>○ not tracked</source>
        <translation>○ nicht verfolgt</translation>
    </message>
    <message>
        <source>Tracking: the cameras confirm the estimate. Ambiguous: another object fits about as well. Corrected: you set the position</source>
        <translation>Verfolgt: Die Kameras bestätigen die Schätzung. Mehrdeutig: Ein anderes Objekt passt etwa genauso gut. Korrigiert: Sie haben die Position gesetzt</translation>
    </message>
    <message>
        <source>Number of cameras that see the target</source>
        <translation>Zahl der Kameras, die das Ziel sehen</translation>
    </message>
    <message>
        <source>Existence probability: how likely it is that the target is there and tracked, 0 to 1</source>
        <translation>Existenzwahrscheinlichkeit: wie wahrscheinlich es ist, dass das Ziel da ist und verfolgt wird, 0 bis 1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryPanel</name>
    <message>
        <source>Trajectory</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Speed and height over time</source>
        <translation>Geschwindigkeit und Höhe über die Zeit</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message numerus="yes">
        <source>%n rows are on the clipboard as CSV.</source>
        <translation>
            <numerusform>%n Zeile liegt als CSV in der Zwischenablage.</numerusform>
            <numerusform>%n Zeilen liegen als CSV in der Zwischenablage.</numerusform>
        </translation>
    </message>
    <message>
        <source>The trajectory appears here as soon as the target is tracked.</source>
        <translation>Die Bahn erscheint hier, sobald das Ziel verfolgt wird.</translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n Messpunkt</numerusform>
            <numerusform>%n Messpunkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples, no gaps</source>
        <translation>
            <numerusform>%n Messpunkt, keine Lücken</numerusform>
            <numerusform>%n Messpunkte, keine Lücken</numerusform>
        </translation>
    </message>
    <message>
        <source>The boxes are on the clipboard as CSV.</source>
        <translation>Die Rahmen sind als CSV in der Zwischenablage.</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>Korrektur entfernen</translation>
    </message>
    <message>
        <source>Speed and height appear during tracking.</source>
        <translation>Geschwindigkeit und Höhe erscheinen, sobald die Verfolgung läuft.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::UncertaintyMapForm</name>
    <message>
        <source>Show the map in the bird&apos;s-eye view</source>
        <translation>Die Karte in der Vogelperspektive zeigen</translation>
    </message>
    <message>
        <source>Show the position error to expect for a target at each point. The map changes whenever a camera moves</source>
        <translation>Zeigen, welcher Positionsfehler eines Ziels an jedem Punkt zu erwarten ist. Die Karte folgt jeder Bewegung einer Kamera</translation>
    </message>
    <message>
        <source>Colors show</source>
        <translation>Farben zeigen</translation>
    </message>
    <message>
        <source>the expected error</source>
        <translation>den erwarteten Fehler</translation>
    </message>
    <message>
        <source>the number of cameras</source>
        <translation>die Zahl der Kameras</translation>
    </message>
    <message>
        <source>Meaning of the colors</source>
        <translation>Bedeutung der Farben</translation>
    </message>
    <message>
        <source>The expected error (standard deviation in the worst direction), or the number of cameras that see a point</source>
        <translation>Der erwartete Fehler (Standardabweichung in der schlechtesten Richtung), oder die Zahl der Kameras, die einen Punkt sehen</translation>
    </message>
    <message>
        <source>Acceptable error</source>
        <translation>Zulässiger Fehler</translation>
    </message>
    <message>
        <source>Errors up to this value are blue in the map. The summary and the search for a camera position also use this value</source>
        <translation>Fehler bis zu diesem Wert sind in der Karte blau. Auch die Zusammenfassung und die Suche nach einer Kameraposition verwenden diesen Wert</translation>
    </message>
    <message>
        <source>Detection error</source>
        <translation>Erkennungsfehler</translation>
    </message>
    <message>
        <source>Error of a target&apos;s position in an image, in pixels (one standard deviation)</source>
        <translation>Fehler der Position eines Ziels im Bild, in Pixeln (eine Standardabweichung)</translation>
    </message>
    <message>
        <source>Layer at</source>
        <translation>Schicht bei</translation>
    </message>
    <message>
        <source>Show the map in a horizontal layer</source>
        <translation>Die Karte in einer waagrechten Schicht zeigen</translation>
    </message>
    <message>
        <source>Height of the layer above the floor</source>
        <translation>Höhe der Schicht über dem Boden</translation>
    </message>
    <message>
        <source>Surfaces around good and fair regions</source>
        <translation>Flächen um gute und brauchbare Bereiche</translation>
    </message>
    <message>
        <source>Volume: minimum x, y, z</source>
        <translation>Raum: kleinste x, y, z</translation>
    </message>
    <message>
        <source>Volume: maximum x, y, z</source>
        <translation>Raum: größte x, y, z</translation>
    </message>
    <message>
        <source>Minimum %1 of the map&apos;s volume</source>
        <translation>Kleinster Wert von %1 im Raum der Karte</translation>
    </message>
    <message>
        <source>Maximum %1 of the map&apos;s volume</source>
        <translation>Größter Wert von %1 im Raum der Karte</translation>
    </message>
    <message>
        <source>Set from reference grid</source>
        <translation>Aus Bezugsgitter setzen</translation>
    </message>
    <message>
        <source>Use the volume above the reference grid, up to the highest camera</source>
        <translation>Den Raum über dem Bezugsgitter verwenden, bis zur höchsten Kamera</translation>
    </message>
    <message>
        <source>Height of the layer above the floor, in meters</source>
        <translation>Höhe der Schicht über dem Boden in Metern</translation>
    </message>
    <message>
        <source>Show surfaces in the room. For the error: around the regions with at most 0.4, 1 and 2 times the acceptable error. For the number of cameras: around the regions that two, three and four cameras see</source>
        <translation>Flächen im Raum zeigen. Beim Fehler: um die Bereiche mit höchstens dem 0,4-, 1- und 2-fachen des zulässigen Fehlers. Bei der Zahl der Kameras: um die Bereiche, die zwei, drei und vier Kameras sehen</translation>
    </message>
    <message>
        <source>Smallest x, y and z of the volume, in meters</source>
        <translation>Kleinste Werte von x, y und z des Raums, in Metern</translation>
    </message>
    <message>
        <source>Largest x, y and z of the volume, in meters</source>
        <translation>Größte Werte von x, y und z des Raums, in Metern</translation>
    </message>
    <message>
        <source>The error is at most %2 in %1 of the volume. Fewer than two cameras see %3 of the volume</source>
        <translation>Der Fehler ist in %1 des Raums höchstens %2. Weniger als zwei Kameras sehen %3 des Raums</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VideoDialog</name>
    <message>
        <source>Export video</source>
        <translation>Video exportieren</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>Datei, die geschrieben wird</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Durchsuchen …</translation>
    </message>
    <message>
        <source>Choose the file to write</source>
        <translation>Die Datei wählen, die geschrieben wird</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop the export. No file is written</source>
        <translation>Den Export abbrechen; es bleibt keine Datei zurück</translation>
    </message>
    <message>
        <source>Write the video in the background</source>
        <translation>Das Video im Hintergrund schreiben</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close; a running export continues</source>
        <translation>Schließen; ein laufender Export geht weiter</translation>
    </message>
    <message>
        <source>Saved the video %1.</source>
        <translation>Das Video %1 wurde gespeichert.</translation>
    </message>
    <message>
        <source>The export was canceled.</source>
        <translation>Der Export wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 gibt es schon; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>no view is checked</source>
        <translation>keine Ansicht ist angekreuzt</translation>
    </message>
    <message>
        <source>Images: %1. Length: %2. Size: %3 × %4 pixels.</source>
        <translation>Bilder: %1. Länge: %2. Größe: %3 × %4 Pixel.</translation>
    </message>
    <message>
        <source>This computer draws the bird&apos;s-eye view slowly. It is drawn in a smaller size and enlarged.</source>
        <translation>Dieser Computer zeichnet die Vogelperspektive langsam. Sie wird kleiner gezeichnet und vergrößert.</translation>
    </message>
    <message>
        <source>This computer has no encoder for videos.</source>
        <translation>Dieser Computer hat keinen Encoder für Videos.</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>The export was stopped because the run has ended.</source>
        <translation>Der Export wurde beendet, weil der Lauf zu Ende ist.</translation>
    </message>
    <message>
        <source>The export was stopped because the run was restarted.</source>
        <translation>Der Export wurde beendet, weil der Lauf neu gestartet wurde.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VideoForm</name>
    <message>
        <source>camera images</source>
        <translation>Kamerabilder</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <comment>pixels</comment>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>MP4 (H.264)</source>
        <translation>MP4 (H.264)</translation>
    </message>
    <message>
        <source>WebM (VP8)</source>
        <translation>WebM (VP8)</translation>
    </message>
    <message>
        <source>AVI (Motion JPEG)</source>
        <translation>AVI (Motion JPEG)</translation>
    </message>
    <message>
        <source>Matroska (FFV1, lossless)</source>
        <translation>Matroska (FFV1, verlustfrei)</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>The checked views are shown side by side</source>
        <translation>Die angekreuzten Ansichten stehen nebeneinander</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Time in the recording at which the video begins, 0 to 1,000,000 s</source>
        <translation>Zeit in der Aufnahme, bei der das Video beginnt, 0 bis 1.000.000 s</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Time in the recording at which the video ends, 0 to 1,000,000 s. The end is the last tracked frame; later frames have no results</source>
        <translation>Zeit in der Aufnahme, bei der das Video endet, 0 bis 1.000.000 s. Das Ende ist das letzte verfolgte Bild; spätere Bilder haben keine Ergebnisse</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Speed of the video, up to 100: 1 is real time, 0.1 is ten times slower, and 8 is eight times faster. With 0, every frame is shown once</source>
        <translation>Geschwindigkeit des Videos, bis 100: 1 ist Echtzeit, 0,1 ist zehnmal langsamer, und 8 ist achtmal schneller. Mit 0 wird jeder Frame einmal gezeigt</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Width and height of the video in pixels</source>
        <translation>Breite und Höhe des Videos in Pixeln</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>Images of the video per second, 1 to 240</source>
        <translation>Bilder des Videos pro Sekunde, 1 bis 240</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Formats that this computer can write</source>
        <translation>Formate, die dieser Computer schreiben kann</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>show every frame once</source>
        <translation>jedes Bild einmal zeigen</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>wie aufgenommen</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> pro Sekunde</translation>
    </message>
    <message>
        <source>Titles of the views</source>
        <translation>Titel der Ansichten</translation>
    </message>
    <message>
        <source>Write the name of each view into its corner</source>
        <translation>Den Namen jeder Ansicht in ihre Ecke schreiben</translation>
    </message>
    <message>
        <source>Frame and time</source>
        <translation>Frame und Zeit</translation>
    </message>
    <message>
        <source>Write the name of the recording, the frame number and the time into the video</source>
        <translation>Den Namen der Aufnahme, die Nummer des Frames und die Zeit in das Video schreiben</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VideoPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Choose the image of the video that the preview shows</source>
        <translation>Das Bild des Videos wählen, das die Vorschau zeigt</translation>
    </message>
    <message>
        <source>Image %1 of %2: frame %3</source>
        <translation>Bild %1 von %2: Bild %3 der Aufnahme</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewButtons</name>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>View from above: X to the right, Y up. Drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>Blick von oben: X nach rechts, Y nach oben. Ziehen verschiebt, das Rad zoomt, ein Doppelklick zeigt alles.</translation>
    </message>
    <message>
        <source>View from the front: X to the right, Z up. Drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>Blick von vorn: X nach rechts, Z nach oben. Ziehen verschiebt, das Rad zoomt, ein Doppelklick zeigt alles.</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Fit everything in the view without changing the viewing direction (or double-click)</source>
        <translation>Alles in die Ansicht einpassen, ohne die Blickrichtung zu ändern (auch per Doppelklick)</translation>
    </message>
    <message>
        <source>Perspective view. Drag to orbit, Shift-drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>Perspektive. Ziehen dreht, Umschalt und Ziehen verschiebt, das Rad zoomt, ein Doppelklick zeigt alles.</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>View from the side: Y to the right, Z up. Drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>Blick von der Seite: Y nach rechts, Z nach oben. Ziehen verschiebt, das Rad zoomt, ein Doppelklick zeigt alles.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewPictures</name>
    <message>
        <source>Save picture as PNG…</source>
        <translation>Bild als PNG speichern…</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Save a picture of %1</source>
        <translation>Ein Bild von %1 speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Saved the picture %1.</source>
        <translation>Das Bild %1 wurde gespeichert.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VolumeForm</name>
    <message>
        <source>Minimum X, Y, Z</source>
        <translation>Kleinste X, Y, Z</translation>
    </message>
    <message>
        <source>Maximum X, Y, Z</source>
        <translation>Größte X, Y, Z</translation>
    </message>
    <message>
        <source>Minimum %1 of the volume of interest</source>
        <translation>Kleinster Wert von %1 im Suchraum</translation>
    </message>
    <message>
        <source>Maximum %1 of the volume of interest</source>
        <translation>Größter Wert von %1 im Suchraum</translation>
    </message>
    <message>
        <source>Compute from cameras</source>
        <translation>Aus den Kameras</translation>
    </message>
    <message>
        <source>Search for targets in the box around the region that at least two cameras see</source>
        <translation>Ziele in dem Quader suchen, der umschließt, was mindestens zwei Kameras sehen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
    <message>
        <source>Search for targets anywhere</source>
        <translation>Ziele überall suchen</translation>
    </message>
    <message>
        <source>Set volume of interest</source>
        <translation>Suchraum festlegen</translation>
    </message>
    <message>
        <source>Remove volume of interest</source>
        <translation>Suchraum entfernen</translation>
    </message>
    <message>
        <source>Targets are searched for only inside this box.</source>
        <translation>Ziele werden nur in diesem Quader gesucht.</translation>
    </message>
    <message>
        <source>None: targets are searched for everywhere. The numbers show the region that the cameras see; change one of them to search in a box.</source>
        <translation>Keiner: Ziele werden überall gesucht. Die Zahlen zeigen den Bereich, den die Kameras sehen; ändern Sie eine, um in einem Quader zu suchen.</translation>
    </message>
    <message>
        <source>None: targets are searched for anywhere. Change a number to search in a box.</source>
        <translation>Keiner: Ziele werden überall gesucht. Ändern Sie eine Zahl, um in einem Quader zu suchen.</translation>
    </message>
    <message>
        <source>Change volume of interest</source>
        <translation>Suchraum ändern</translation>
    </message>
    <message>
        <source>Smallest x, y and z of the volume of interest, in meters. Targets are searched for only inside this box</source>
        <translation>Kleinste Werte von x, y und z des Suchraums, in Metern. Ziele werden nur in diesem Quader gesucht</translation>
    </message>
    <message>
        <source>Largest x, y and z of the volume of interest, in meters. Targets are searched for only inside this box</source>
        <translation>Größte Werte von x, y und z des Suchraums, in Metern. Ziele werden nur in diesem Quader gesucht</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrationPage</name>
    <message>
        <source>Align the cameras by hand until they are roughly right. Then wave the ball, or a wand with two balls, through the whole volume, and press Refine cameras.</source>
        <translation>Richten Sie die Kameras von Hand aus, bis sie ungefähr stimmen. Schwenken Sie dann den Ball oder einen Stab mit zwei Bällen durch den ganzen Raum, und drücken Sie „Kameras verfeinern“.</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Wand</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Align the cameras by hand until they are roughly right. Then refine them with a recording in which you wave a ball, or a wand with two balls, through the whole volume.</source>
        <translation>Richten Sie die Kameras von Hand aus, bis sie ungefähr stimmen. Verfeinern Sie sie dann mit einer Aufnahme, in der Sie einen Ball oder einen Stab mit zwei Bällen durch den ganzen Raum schwenken.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrator</name>
    <message>
        <source>Press “Start waving”, then wave for half a minute in the volume in which you want to track.</source>
        <translation>Drücken Sie „Schwenken beginnen“, und schwenken Sie eine halbe Minute lang in dem Raum, in dem verfolgt werden soll.</translation>
    </message>
    <message>
        <source>Refine cameras with a wand</source>
        <translation>Kameras mit Stab verfeinern</translation>
    </message>
    <message>
        <source>Refine cameras with a ball</source>
        <translation>Kameras mit Ball verfeinern</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandForm</name>
    <message>
        <source>the ball&apos;s diameter</source>
        <translation>dem Durchmesser des Balls</translation>
    </message>
    <message>
        <source>the ball&apos;s diameter, %1</source>
        <translation>dem Durchmesser des Balls, %1</translation>
    </message>
    <message>
        <source>the current camera positions</source>
        <translation>den aktuellen Kamerapositionen</translation>
    </message>
    <message>
        <source>a known distance</source>
        <translation>einer bekannten Strecke</translation>
    </message>
    <message>
        <source>Wand</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>one ball</source>
        <translation>ein Ball</translation>
    </message>
    <message>
        <source>wand with two balls</source>
        <translation>Stab mit zwei Bällen</translation>
    </message>
    <message>
        <source>Kind of wand</source>
        <translation>Art des Stabs</translation>
    </message>
    <message>
        <source>A wand with two balls also gives the scale. This scale is more accurate than one from a diameter or a distance</source>
        <translation>Ein Stab mit zwei Bällen gibt auch den Maßstab, und zwar genauer als ein Durchmesser oder eine Strecke</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Ball</translation>
    </message>
    <message>
        <source>The target that you wave; it is detected by its color</source>
        <translation>Das Ziel, das Sie schwenken; es wird an seiner Farbe erkannt</translation>
    </message>
    <message>
        <source>Second ball</source>
        <translation>Zweiter Ball</translation>
    </message>
    <message>
        <source>The target at the other end of the wand</source>
        <translation>Das Ziel am anderen Ende des Stabs</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of the wand</source>
        <translation>Länge des Stabs</translation>
    </message>
    <message>
        <source>Distance from the center of one ball to the center of the other</source>
        <translation>Abstand von der Mitte des einen Balls zur Mitte des anderen</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Scale from</source>
        <translation>Maßstab von</translation>
    </message>
    <message>
        <source>Source of the scale</source>
        <translation>Quelle des Maßstabs</translation>
    </message>
    <message>
        <source>Images alone cannot show whether a room is large or small. A scale from the diameter of a ball is accurate to about one percent. A scale from a distance is as accurate as your measurement</source>
        <translation>Bilder allein zeigen nicht, ob ein Raum groß oder klein ist. Ein Maßstab aus dem Durchmesser eines Balls ist auf etwa ein Prozent genau. Ein Maßstab aus einer Strecke ist so genau wie Ihre Messung</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Known distance</source>
        <translation>Bekannte Strecke</translation>
    </message>
    <message>
        <source>Distance between the two positions at which the center of the ball was held</source>
        <translation>Abstand der beiden Positionen, an denen die Mitte des Balls gehalten wurde</translation>
    </message>
    <message>
        <source>Initial error</source>
        <translation>Anfangsfehler</translation>
    </message>
    <message>
        <source>Expected error of the initial positions</source>
        <translation>Erwarteter Fehler der anfänglichen Positionen</translation>
    </message>
    <message>
        <source>Roughly how far each camera may be from its true position</source>
        <translation>Etwa wie weit jede Kamera von ihrer wahren Position entfernt sein kann</translation>
    </message>
    <message>
        <source>Expected error of the initial rotations</source>
        <translation>Erwarteter Fehler der anfänglichen Drehungen</translation>
    </message>
    <message>
        <source>Roughly how far each camera may be rotated from its true orientation</source>
        <translation>Etwa wie weit jede Kamera gegen ihre wahre Ausrichtung gedreht sein kann</translation>
    </message>
    <message>
        <source>Find delays</source>
        <translation>Verzögerungen suchen</translation>
    </message>
    <message>
        <source>Find focal lengths</source>
        <translation>Brennweiten suchen</translation>
    </message>
    <message>
        <source>Also compute the focal length of each camera. Use this for lenses that were never calibrated, or whose zoom has changed</source>
        <translation>Auch die Brennweite jeder Kamera berechnen, bei Objektiven, die nie kalibriert wurden oder deren Zoom sich geändert hat</translation>
    </message>
    <message>
        <source>Find the distortion k1</source>
        <translation>Die Verzeichnung k1 suchen</translation>
    </message>
    <message>
        <source>Also compute the first distortion coefficient of each lens. For this, the ball must be seen up to the edges of the images</source>
        <translation>Auch den ersten Verzeichnungskoeffizienten jedes Objektivs berechnen. Dazu muss der Ball bis an die Bildränder zu sehen sein</translation>
    </message>
    <message>
        <source>Only the selected time span</source>
        <translation>Nur die ausgewählte Zeitspanne</translation>
    </message>
    <message>
        <source>Use only the part of the recording that is selected in the timeline</source>
        <translation>Nur den Teil der Aufnahme verwenden, der in der Zeitleiste gewählt ist</translation>
    </message>
    <message>
        <source>Also compute the delay of each camera. Use this if the cameras do not take their images at the same time</source>
        <translation>Auch die Verzögerung jeder Kamera berechnen, wenn die Kameras ihre Bilder nicht gleichzeitig aufnehmen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandOutcome</name>
    <message>
        <source>Refine cameras</source>
        <translation>Kameras verfeinern</translation>
    </message>
    <message>
        <source>Detect the ball in all images and compute the cameras that fit best</source>
        <translation>Den Ball in allen Bildern erkennen und die am besten passenden Kameras berechnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop and keep the cameras unchanged</source>
        <translation>Anhalten und die Kameras unverändert lassen</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Use calibration anyway</source>
        <translation>Kalibrierung trotzdem verwenden</translation>
    </message>
    <message>
        <source>Use this calibration although it looks wrong; you can undo this</source>
        <translation>Diese Kalibrierung verwenden, obwohl sie falsch aussieht; das lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Bericht speichern…</translation>
    </message>
    <message>
        <source>Refined cameras</source>
        <translation>Verfeinerte Kameras</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>moved cm</source>
        <translation>bewegt cm</translation>
    </message>
    <message>
        <source>rotated °</source>
        <translation>gedreht °</translation>
    </message>
    <message>
        <source>delay ms</source>
        <translation>Verzug ms</translation>
    </message>
    <message>
        <source>Reprojection error: root mean square distance between detected and projected balls</source>
        <translation>Reprojektionsfehler: quadratisches Mittel der Abstände zwischen erkannten und projizierten Bällen</translation>
    </message>
    <message>
        <source>Distance between the old and the new position of the camera</source>
        <translation>Abstand zwischen der alten und der neuen Position der Kamera</translation>
    </message>
    <message>
        <source>Angle between the old and the new orientation of the camera</source>
        <translation>Winkel zwischen der alten und der neuen Ausrichtung der Kamera</translation>
    </message>
    <message>
        <source>The cameras are unchanged.</source>
        <translation>Die Kameras sind unverändert.</translation>
    </message>
    <message>
        <source>The fall gives a gravity of %1 m/s² (9.81 is expected).</source>
        <translation>Der Fall ergibt eine Schwerkraft von %1 m/s² (9,81 wird erwartet).</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>Results for each camera; hover over a heading to see its meaning</source>
        <translation>Ergebnisse für jede Kamera; zeigen Sie auf eine Überschrift, um ihre Bedeutung zu sehen</translation>
    </message>
    <message>
        <source>The cameras have changed since this refinement.</source>
        <translation>Die Kameras haben sich seit diesem Verfeinern geändert.</translation>
    </message>
    <message>
        <source>Additional delay of this camera&apos;s images relative to the first camera</source>
        <translation>Zusätzliche Verzögerung der Bilder dieser Kamera gegenüber der ersten Kamera</translation>
    </message>
    <message>
        <source>Camera delays are saved in the project and used to synchronize images from now on.</source>
        <translation>Die Verzögerungen der Kameras sind im Projekt gespeichert und synchronisieren ab jetzt die Bilder.</translation>
    </message>
    <message>
        <source>Hold down this button to draw the grid with the calibration from before this refinement</source>
        <translation>Diese Schaltfläche gedrückt halten, um das Gitter mit der Kalibrierung vor diesem Verfeinern zu zeichnen</translation>
    </message>
    <message>
        <source>Save a page with all numbers, the residuals as arrows, the coverage and a 3D drawing</source>
        <translation>Eine Seite mit allen Zahlen, den Residuen als Pfeilen, der Abdeckung und einer 3D-Zeichnung speichern</translation>
    </message>
    <message>
        <source>The result is less accurate than the initial camera positions: you entered that their error is at most %1. Wave through more of the volume.</source>
        <translation>Das Ergebnis ist weniger genau als die anfänglichen Kamerapositionen: Für deren Fehler haben Sie höchstens %1 eingegeben. Schwenken Sie durch mehr vom Raum.</translation>
    </message>
    <message>
        <source>Calibrations from different parts of the recording differ from each other %1 times as much as image noise can explain. The stated accuracy takes this into account.</source>
        <translation>Kalibrierungen aus verschiedenen Teilen der Aufnahme weichen %1-mal so stark voneinander ab, wie das Rauschen der Bilder erklärt. Die angegebene Genauigkeit berücksichtigt das.</translation>
    </message>
    <message>
        <source>%1 was far off: the refinement rotates this camera by %2 and moves it by %3, much more than the other cameras. Was it moved after its calibration?</source>
        <translation>%1 lag weit daneben: Die Verfeinerung dreht diese Kamera um %2 und verschiebt sie um %3, viel mehr als die anderen Kameras. Wurde sie nach ihrer Kalibrierung bewegt?</translation>
    </message>
    <message>
        <source>The previous calibration fits the images as well as the new one. Keep the previous one, or wave longer and through more of the volume.</source>
        <translation>Die bisherige Kalibrierung passt genauso gut zu den Bildern wie die neue. Behalten Sie die bisherige, oder schwenken Sie länger und durch mehr des Raumes.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandWaving</name>
    <message>
        <source>Collect positions of the ball from all camera images. If you start again, the positions collected before are discarded</source>
        <translation>Positionen des Balls aus allen Kamerabildern sammeln. Wenn Sie neu beginnen, werden die vorher gesammelten Positionen verworfen</translation>
    </message>
    <message>
        <source>■ Stop waving</source>
        <translation>■ Schwenken beenden</translation>
    </message>
    <message>
        <source>● Start waving</source>
        <translation>● Schwenken beginnen</translation>
    </message>
    <message>
        <source>Stop waving</source>
        <translation>Schwenken beenden</translation>
    </message>
    <message>
        <source>Start waving</source>
        <translation>Schwenken beginnen</translation>
    </message>
    <message>
        <source>No ball positions collected yet.</source>
        <translation>Noch keine Ballpositionen gesammelt.</translation>
    </message>
    <message>
        <source>Every camera has seen the ball often enough: stop waving, or press Refine cameras.</source>
        <translation>Jede Kamera hat den Ball oft genug gesehen: Schwenken beenden, oder „Kameras verfeinern“ drücken.</translation>
    </message>
    <message>
        <source>Frames skipped because they arrived too fast: %1.</source>
        <translation>Übersprungene Bilder, weil sie zu schnell kamen: %1.</translation>
    </message>
    <message>
        <source>The positions of the ball have been recorded for %1 so far.</source>
        <translation>Die Positionen des Balls wurden bisher %1 lang aufgenommen.</translation>
    </message>
    <message>
        <source>Keep waving: each camera should see the ball at least 150 times, spread over at least half of its image.</source>
        <translation>Weiter schwenken: Jede Kamera soll den Ball mindestens 150-mal sehen, verteilt über mindestens die Hälfte ihres Bildes.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WindowMenus</name>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Choose this camera</source>
        <translation>Diese Kamera wählen</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>Choose this target</source>
        <translation>Dieses Ziel wählen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Calibration</source>
        <translation>&amp;Kalibrierung</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Lauf</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Show this view</source>
        <translation>Diese Ansicht zeigen</translation>
    </message>
    <message>
        <source>Switch to this language</source>
        <translation>Zu dieser Sprache wechseln</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Wie das System</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WorldMarkTool</name>
    <message>
        <source>Click point %1 in two images · Esc: stop</source>
        <translation>Punkt %1 in zwei Bildern anklicken · Esc: beenden</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter marks the point there</source>
        <translation>Bild von %1: Pfeiltasten bewegen ein Kreuz, Enter markiert dort den Punkt</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WorldMarks</name>
    <message>
        <source>Turn the world upright</source>
        <translation>Welt aufrichten</translation>
    </message>
    <message>
        <source>Set the floor</source>
        <translation>Boden festlegen</translation>
    </message>
    <message>
        <source>Make a line level</source>
        <translation>Linie waagerecht ausrichten</translation>
    </message>
    <message>
        <source>Set the origin</source>
        <translation>Ursprung festlegen</translation>
    </message>
    <message>
        <source>Set the x axis</source>
        <translation>x-Achse festlegen</translation>
    </message>
    <message>
        <source>Set a distance</source>
        <translation>Abstand festlegen</translation>
    </message>
    <message>
        <source>A, B and C lie on one line. Mark points that are spread over the floor.</source>
        <translation>A, B und C liegen auf einer Geraden. Markieren Sie Punkte, die über den Boden verteilt sind.</translation>
    </message>
    <message>
        <source>The floor is set: A is the origin, and the x axis points to B. The world was rotated by %1.</source>
        <translation>Der Boden ist festgelegt: A ist der Ursprung, und die x-Achse zeigt zu B. Die Welt wurde um %1 gedreht.</translation>
    </message>
    <message>
        <source>All lengths were multiplied by %1.</source>
        <translation>Alle Längen wurden mit %1 multipliziert.</translation>
    </message>
    <message>
        <source>A is now the origin.</source>
        <translation>A ist jetzt der Ursprung.</translation>
    </message>
    <message>
        <source>The world was rotated by %1.</source>
        <translation>Die Welt wurde um %1 gedreht.</translation>
    </message>
    <message>
        <source>Rotate all cameras</source>
        <translation>Alle Kameras drehen</translation>
    </message>
    <message>
        <source>Move all cameras</source>
        <translation>Alle Kameras verschieben</translation>
    </message>
    <message>
        <source>Check a distance</source>
        <translation>Strecke prüfen</translation>
    </message>
    <message>
        <source>The line from A to B is far from horizontal.</source>
        <translation>Die Linie von A nach B ist weit davon entfernt, waagerecht zu sein.</translation>
    </message>
    <message>
        <source>A is directly above or below B, so the x axis cannot point from A to B.</source>
        <translation>A liegt genau über oder unter B, daher kann die x-Achse nicht von A nach B zeigen.</translation>
    </message>
    <message>
        <source>From A to B, the calibration gives %1; you measured %2. The calibration is off by %3 %.</source>
        <translation>Von A nach B ergibt die Kalibrierung %1; Sie haben %2 gemessen. Die Kalibrierung weicht um %3 % ab.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WorldPage</name>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>⚠ The z axis does not seem to point up.</source>
        <translation>⚠ Die z-Achse scheint nicht nach oben zu zeigen.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>x m</source>
        <translation>x m</translation>
    </message>
    <message>
        <source>y m</source>
        <translation>y m</translation>
    </message>
    <message>
        <source>z m</source>
        <translation>z m</translation>
    </message>
    <message>
        <source>± mm</source>
        <translation>± mm</translation>
    </message>
    <message>
        <source>Points of the room that you mark in the images, and their positions. ± is one standard deviation of a position, if clicks are accurate to 2 px.</source>
        <translation>Punkte des Raums, die Sie in den Bildern markieren, und ihre Positionen. ± ist eine Standardabweichung der Position, wenn Klicks auf 2 px genau sind.</translation>
    </message>
    <message>
        <source>Remove marks</source>
        <translation>Markierungen entfernen</translation>
    </message>
    <message>
        <source>Remove the marks of A, B and C from all images</source>
        <translation>Die Markierungen von A, B und C aus allen Bildern entfernen</translation>
    </message>
    <message>
        <source>Floor, origin and scale</source>
        <translation>Boden, Ursprung und Maßstab</translation>
    </message>
    <message>
        <source>Measured distance from A to B</source>
        <translation>Gemessener Abstand von A nach B</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>The distance that you measured in the room, in meters</source>
        <translation>Der Abstand, den Sie im Raum gemessen haben, in Metern</translation>
    </message>
    <message>
        <source>Turn upright</source>
        <translation>Aufrichten</translation>
    </message>
    <message>
        <source>Set floor from A, B and C</source>
        <translation>Boden aus A, B und C festlegen</translation>
    </message>
    <message>
        <source>The floor goes through A, B and C. A becomes the origin, and the x axis points to B.</source>
        <translation>Der Boden geht durch A, B und C. A wird der Ursprung, und die x-Achse zeigt zu B.</translation>
    </message>
    <message>
        <source>Make line A–B level</source>
        <translation>Linie A–B waagerecht</translation>
    </message>
    <message>
        <source>Rotate the world by the smallest angle that makes this line horizontal</source>
        <translation>Die Welt um den kleinsten Winkel drehen, der diese Linie waagerecht macht</translation>
    </message>
    <message>
        <source>Origin at A</source>
        <translation>Ursprung in A</translation>
    </message>
    <message>
        <source>Move the origin to A; the axes keep their directions</source>
        <translation>Den Ursprung nach A verschieben; die Achsen behalten ihre Richtungen</translation>
    </message>
    <message>
        <source>x axis along A–B</source>
        <translation>x-Achse entlang A–B</translation>
    </message>
    <message>
        <source>Rotate the world about the vertical until the x axis points from A to B</source>
        <translation>Die Welt um die Senkrechte drehen, bis die x-Achse von A nach B zeigt</translation>
    </message>
    <message>
        <source>Set scale</source>
        <translation>Maßstab festlegen</translation>
    </message>
    <message>
        <source>Multiply all lengths by one factor, so that the distance from A to B is the measured one</source>
        <translation>Alle Längen mit einem Faktor multiplizieren, sodass der Abstand von A nach B der gemessene ist</translation>
    </message>
    <message>
        <source>Move all cameras together</source>
        <translation>Alle Kameras gemeinsam verschieben</translation>
    </message>
    <message>
        <source>Shift of all cameras along %1</source>
        <translation>Verschiebung aller Kameras entlang %1</translation>
    </message>
    <message>
        <source>How far all cameras move along %1, in meters</source>
        <translation>Wie weit sich alle Kameras entlang %1 verschieben, in Metern</translation>
    </message>
    <message>
        <source>Quarter turn about %1</source>
        <translation>Vierteldrehung um %1</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Rotation of all cameras about the vertical axis</source>
        <translation>Drehung aller Kameras um die Senkrechte</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Rotate and move all cameras together</source>
        <translation>Alle Kameras gemeinsam drehen und verschieben</translation>
    </message>
    <message>
        <source>Quarter turn</source>
        <translation>Vierteldrehung</translation>
    </message>
    <message>
        <source>A: origin</source>
        <translation>A: Ursprung</translation>
    </message>
    <message>
        <source>B: on the x axis</source>
        <translation>B: auf der x-Achse</translation>
    </message>
    <message>
        <source>C: on the floor</source>
        <translation>C: auf dem Boden</translation>
    </message>
    <message>
        <source>Mark in images</source>
        <translation>In Bildern markieren</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Set the floor, the origin and the scale of the room. The cameras keep their positions relative to each other.</source>
        <translation>Legen Sie den Boden, den Ursprung und den Maßstab des Raums fest. Die Kameras behalten ihre Lage zueinander.</translation>
    </message>
    <message>
        <source>Compare the distance from A to B in the calibration with the distance that you measured. Nothing is changed.</source>
        <translation>Die Strecke von A nach B in der Kalibrierung mit der vergleichen, die Sie gemessen haben. Nichts wird geändert.</translation>
    </message>
    <message>
        <source>Set floor from the board shown</source>
        <translation>Boden aus der gezeigten Tafel setzen</translation>
    </message>
    <message>
        <source>Use a board that lies flat on the floor in the images shown. Its first corner becomes the origin, and the x axis runs along its rows. Describe the board on the page Board.</source>
        <translation>Eine Tafel verwenden, die in den gezeigten Bildern flach auf dem Boden liegt. Ihre erste Ecke wird der Ursprung, und die x-Achse verläuft entlang ihrer Reihen. Beschreiben Sie die Tafel auf der Seite Tafel.</translation>
    </message>
    <message>
        <source>Rotate the world by quarter turns until its upward direction points up in the images</source>
        <translation>Die Welt um Vierteldrehungen drehen, bis ihre Aufwärtsrichtung in den Bildern nach oben zeigt</translation>
    </message>
    <message>
        <source>Rotate all cameras by 90° about the %1 axis, counterclockwise if the axis points toward you</source>
        <translation>Alle Kameras um 90° um die %1-Achse drehen, gegen den Uhrzeigersinn, wenn die Achse auf Sie zeigt</translation>
    </message>
    <message>
        <source>Angle by which all cameras rotate about the vertical through the origin, counterclockwise as seen from above. The cameras are rotated first and then moved</source>
        <translation>Winkel, um den sich alle Kameras um die Senkrechte durch den Ursprung drehen, von oben gesehen gegen den Uhrzeigersinn. Die Kameras werden zuerst gedreht und dann verschoben</translation>
    </message>
    <message>
        <source>Click the selected point in two or more images. Near a corner, the click moves exactly onto the corner; hold Alt to prevent this. Press Esc to finish.</source>
        <translation>Klicken Sie den gewählten Punkt in mindestens zwei Bildern an. Nahe einer Ecke springt der Klick genau auf die Ecke; halten Sie Alt gedrückt, um das zu verhindern. Esc beendet es.</translation>
    </message>
    <message>
        <source>marked</source>
        <translation>markiert</translation>
    </message>
</context>
</TS>
