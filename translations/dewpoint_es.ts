<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>New project…</source>
        <translation>Proyecto nuevo…</translation>
    </message>
    <message>
        <source>Make a project from videos or connected cameras</source>
        <translation>Crear un proyecto con vídeos o cámaras conectadas</translation>
    </message>
    <message>
        <source>Open project…</source>
        <translation>Abrir proyecto…</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Abrir un proyecto</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Abrir la demostración</translation>
    </message>
    <message>
        <source>Open the simulated demo scene</source>
        <translation>Abrir la escena de demostración simulada</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Guardar el proyecto</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Guardar el proyecto con otro nombre</translation>
    </message>
    <message>
        <source>Close project</source>
        <translation>Cerrar el proyecto</translation>
    </message>
    <message>
        <source>Back to the start page</source>
        <translation>Volver a la página de inicio</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Quit Dewpoint</source>
        <translation>Salir de Dewpoint</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Edición</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Deshacer el último cambio</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Make the change that was taken back again</source>
        <translation>Volver a hacer el cambio deshecho</translation>
    </message>
    <message>
        <source>Shortcuts…</source>
        <translation>Atajos…</translation>
    </message>
    <message>
        <source>See and change all shortcuts</source>
        <translation>Ver y cambiar todos los atajos</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Reproducir o pausar</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Fotograma siguiente</translation>
    </message>
    <message>
        <source>Track one frame and pause</source>
        <translation>Seguir un fotograma y pausar</translation>
    </message>
    <message>
        <source>One iteration</source>
        <translation>Una iteración</translation>
    </message>
    <message>
        <source>One filter iteration on the frame shown, and pause</source>
        <translation>Una iteración del filtro sobre el fotograma mostrado y pausar</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>Start over with the same random numbers</source>
        <translation>Empezar de nuevo con los mismos números aleatorios</translation>
    </message>
    <message>
        <source>Restart with a new seed</source>
        <translation>Reiniciar con otra semilla</translation>
    </message>
    <message>
        <source>Start over with other random numbers</source>
        <translation>Empezar de nuevo con otros números aleatorios</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Show mask</source>
        <translation>Mostrar máscara</translation>
    </message>
    <message>
        <source>Show where the cameras see the target&apos;s color</source>
        <translation>Mostrar dónde ven las cámaras el color del objetivo</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view from above: the XY plane</source>
        <translation>Vista de pájaro desde arriba: el plano XY</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view from the front: the XZ plane</source>
        <translation>Vista de pájaro desde el frente: el plano XZ</translation>
    </message>
    <message>
        <source>Search actions…</source>
        <translation>Buscar acciones…</translation>
    </message>
    <message>
        <source>Find any action by its name</source>
        <translation>Encontrar cualquier acción por su nombre</translation>
    </message>
    <message>
        <source>Put all views back where they were at first</source>
        <translation>Poner todas las vistas donde estaban al principio</translation>
    </message>
    <message>
        <source>Colors of the system</source>
        <translation>Colores del sistema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Light colors</source>
        <translation>Colores claros</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Dark colors</source>
        <translation>Colores oscuros</translation>
    </message>
    <message>
        <source>Remove the target</source>
        <translation>Quitar el objetivo</translation>
    </message>
    <message>
        <source>Stop following the target that is chosen</source>
        <translation>Dejar de seguir el objetivo elegido</translation>
    </message>
    <message>
        <source>Learn the color</source>
        <translation>Aprender el color</translation>
    </message>
    <message>
        <source>Then click the target in a camera image: its color is learned</source>
        <translation>Después haga clic en el objetivo en una imagen: se aprende su color</translation>
    </message>
    <message>
        <source>Add a target</source>
        <translation>Añadir un objetivo</translation>
    </message>
    <message>
        <source>Follow one more thing: click it in a camera image</source>
        <translation>Seguir una cosa más: haga clic en ella en una imagen</translation>
    </message>
    <message>
        <source>Export trajectory…</source>
        <translation>Exportar la trayectoria…</translation>
    </message>
    <message>
        <source>Write the trajectory so far for another program</source>
        <translation>Escribir la trayectoria hasta ahora para otro programa</translation>
    </message>
    <message>
        <source>Save a picture of a view…</source>
        <translation>Guardar una imagen de una vista…</translation>
    </message>
    <message>
        <source>Save a camera image, the bird&apos;s-eye view or a plot as PNG</source>
        <translation>Guardar una imagen de cámara, la vista de pájaro o una gráfica como PNG</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Fotograma anterior</translation>
    </message>
    <message>
        <source>Show the frame before this one as it was</source>
        <translation>Mostrar el fotograma anterior tal como era</translation>
    </message>
    <message>
        <source>Back to now</source>
        <translation>Volver al presente</translation>
    </message>
    <message>
        <source>Show again where the run stands</source>
        <translation>Mostrar de nuevo el punto en que está la ejecución</translation>
    </message>
    <message>
        <source>Track again from here</source>
        <translation>Seguir de nuevo desde aquí</translation>
    </message>
    <message>
        <source>Track again from the moment shown, with the method, parameters and colors of now; pausing stops it</source>
        <translation>Seguir de nuevo desde el momento mostrado, con el método, los parámetros y los colores actuales; la pausa lo detiene</translation>
    </message>
    <message>
        <source>Mark this moment</source>
        <translation>Marcar este momento</translation>
    </message>
    <message>
        <source>Put a named mark on the moment shown</source>
        <translation>Poner una marca con nombre en el momento mostrado</translation>
    </message>
    <message>
        <source>Remove the mark</source>
        <translation>Quitar la marca</translation>
    </message>
    <message>
        <source>Take the mark away from the moment shown</source>
        <translation>Quitar la marca del momento mostrado</translation>
    </message>
    <message>
        <source>Previous mark</source>
        <translation>Marca anterior</translation>
    </message>
    <message>
        <source>Show the moment of the mark before this one</source>
        <translation>Mostrar el momento de la marca anterior</translation>
    </message>
    <message>
        <source>Next mark</source>
        <translation>Marca siguiente</translation>
    </message>
    <message>
        <source>Show the moment of the next mark</source>
        <translation>Mostrar el momento de la marca siguiente</translation>
    </message>
    <message>
        <source>Zoom to the selected span</source>
        <translation>Ampliar el tramo seleccionado</translation>
    </message>
    <message>
        <source>Let the timeline show the selected span only</source>
        <translation>Mostrar en la línea de tiempo solo el tramo seleccionado</translation>
    </message>
    <message>
        <source>Show evidence</source>
        <translation>Mostrar evidencias</translation>
    </message>
    <message>
        <source>Show how likely the cameras find each place around the target, and which places were considered</source>
        <translation>Mostrar lo probable que es para las cámaras cada lugar alrededor del objetivo y qué lugares se consideraron</translation>
    </message>
    <message>
        <source>Show best particle</source>
        <translation>Mostrar la mejor partícula</translation>
    </message>
    <message>
        <source>Mark the particle of highest weight (MAP) of each target with a triangle, in all views</source>
        <translation>Marcar con un triángulo, en todas las vistas, la partícula de mayor peso (MAP) de cada objetivo</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Plot spread</source>
        <translation>Mostrar dispersión</translation>
    </message>
    <message>
        <source>Standard deviation of the particles along x, y and z</source>
        <translation>Desviación típica de las partículas en x, y y z</translation>
    </message>
    <message>
        <source>Plot effective sample size</source>
        <translation>Mostrar tamaño efectivo de la muestra</translation>
    </message>
    <message>
        <source>How many particles the weighted ones are worth, and how many there are</source>
        <translation>Cuántas partículas valen las ponderadas y cuántas hay</translation>
    </message>
    <message>
        <source>Plot likelihood</source>
        <translation>Mostrar verosimilitud</translation>
    </message>
    <message>
        <source>What each camera says of the estimate: its log likelihood</source>
        <translation>Lo que dice cada cámara de la estimación: su log-verosimilitud</translation>
    </message>
    <message>
        <source>Plot existence</source>
        <translation>Mostrar existencia</translation>
    </message>
    <message>
        <source>Probability that the target is at the estimate, by all cameras and by each alone</source>
        <translation>Probabilidad de que el objetivo esté en la estimación, según todas las cámaras y según cada una</translation>
    </message>
    <message>
        <source>Plot error</source>
        <translation>Mostrar error</translation>
    </message>
    <message>
        <source>Distance of the estimate from the truth, where it is known</source>
        <translation>Distancia de la estimación a la verdad, donde se conoce</translation>
    </message>
    <message>
        <source>Plot time per step</source>
        <translation>Mostrar tiempo por paso</translation>
    </message>
    <message>
        <source>Microseconds that each filter iteration took, per target</source>
        <translation>Microsegundos que tardó cada iteración del filtro, por objetivo</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>En el tiempo</translation>
    </message>
    <message>
        <source>Plot over seconds instead of filter iterations</source>
        <translation>Representar en segundos en lugar de iteraciones del filtro</translation>
    </message>
    <message>
        <source>Whole run</source>
        <translation>Toda la ejecución</translation>
    </message>
    <message>
        <source>Plot the whole run again (double click does the same)</source>
        <translation>Mostrar de nuevo toda la ejecución (doble clic hace lo mismo)</translation>
    </message>
    <message>
        <source>Copy plots as CSV</source>
        <translation>Copiar gráficos como CSV</translation>
    </message>
    <message>
        <source>Copy the numbers of the plots shown, as a table</source>
        <translation>Copiar los números de los gráficos mostrados como tabla</translation>
    </message>
    <message>
        <source>Save plots as picture…</source>
        <translation>Guardar gráficos como imagen…</translation>
    </message>
    <message>
        <source>Save the plots as shown, as SVG or PNG</source>
        <translation>Guardar los gráficos como se muestran, en SVG o PNG</translation>
    </message>
    <message>
        <source>Copy trajectory as CSV</source>
        <translation>Copiar trayectoria como CSV</translation>
    </message>
    <message>
        <source>Copy the selected rows of the trajectory, or all</source>
        <translation>Copiar las filas elegidas de la trayectoria, o todas</translation>
    </message>
    <message>
        <source>Calibrate by hand…</source>
        <translation>Calibrar a mano…</translation>
    </message>
    <message>
        <source>Adjust cameras until a grid lies on the real thing in their images</source>
        <translation>Ajustar las cámaras hasta que una cuadrícula coincida con lo real en sus imágenes</translation>
    </message>
    <message>
        <source>Import calibration…</source>
        <translation>Importar calibración…</translation>
    </message>
    <message>
        <source>Take the cameras&apos; calibration from a file of any tool</source>
        <translation>Tomar la calibración de las cámaras de un archivo de cualquier programa</translation>
    </message>
    <message>
        <source>Export calibration…</source>
        <translation>Exportar calibración…</translation>
    </message>
    <message>
        <source>Write the cameras&apos; calibration for another tool</source>
        <translation>Escribir la calibración de las cámaras para otro programa</translation>
    </message>
    <message>
        <source>Calibrate by waving…</source>
        <translation>Calibrar agitando…</translation>
    </message>
    <message>
        <source>Refine cameras with a waved ball, or a stick with two balls</source>
        <translation>Refinar las cámaras con una pelota agitada o una vara con dos pelotas</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>Calibrate with a board…</source>
        <translation>Calibrar con un tablero…</translation>
    </message>
    <message>
        <source>Find lenses and places of the cameras with a printed board</source>
        <translation>Hallar objetivos y posiciones de las cámaras con un tablero impreso</translation>
    </message>
    <message>
        <source>Print a calibration board…</source>
        <translation>Imprimir un tablero de calibración…</translation>
    </message>
    <message>
        <source>Write the board to calibrate with as a PDF in its true size</source>
        <translation>Escribir el tablero de calibración como PDF a tamaño real</translation>
    </message>
    <message>
        <source>Plan the rig…</source>
        <translation>Planificar el montaje…</translation>
    </message>
    <message>
        <source>See how well the cameras will measure, and where one more would help</source>
        <translation>Ver qué tal medirán las cámaras y dónde ayudaría otra</translation>
    </message>
    <message>
        <source>Show the map of expected errors</source>
        <translation>Mostrar el mapa de errores esperados</translation>
    </message>
    <message>
        <source>Show in the bird&apos;s-eye view how far off a target is expected to be at each place</source>
        <translation>Mostrar en la vista de pájaro cuánto se espera que se desvíe un objetivo en cada lugar</translation>
    </message>
    <message>
        <source>Add a camera to plan</source>
        <translation>Añadir una cámara al plan</translation>
    </message>
    <message>
        <source>Add a camera that is not there yet, to be dragged about</source>
        <translation>Añadir una cámara que aún no existe, para arrastrarla</translation>
    </message>
    <message>
        <source>Re-solve the bumped camera</source>
        <translation>Resolver de nuevo la cámara movida</translation>
    </message>
    <message>
        <source>Calibrate the camera that was turned during the run as it stands now; all others stay</source>
        <translation>Calibrar la cámara que se giró durante la ejecución tal como está ahora; las demás no cambian</translation>
    </message>
    <message>
        <source>Find the best place for one more camera</source>
        <translation>Buscar el mejor lugar para otra cámara</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the place from which one more camera helps most</source>
        <translation>Buscar en paredes y techo el lugar desde el que más ayuda otra cámara</translation>
    </message>
    <message>
        <source>Experiments…</source>
        <translation>Experimentos…</translation>
    </message>
    <message>
        <source>Make the figures of the papers anew, with a report</source>
        <translation>Rehacer las figuras de los artículos, con un informe</translation>
    </message>
    <message>
        <source>Take a box</source>
        <translation>Tomar un recuadro</translation>
    </message>
    <message>
        <source>Export volumes of people…</source>
        <translation>Exportar volúmenes de las personas…</translation>
    </message>
    <message>
        <source>Write places, volumes, hulls and densities on the floor of all people as tables</source>
        <translation>Escribir como tablas los lugares, volúmenes, envolventes y densidades en el suelo de todas las personas</translation>
    </message>
    <message>
        <source>A person stands here…</source>
        <translation>Aquí hay una persona…</translation>
    </message>
    <message>
        <source>Say where somebody is: by a click on the person in a camera image, or on the floor in the bird&apos;s-eye view</source>
        <translation>Decir dónde hay alguien: con un clic en la persona en una imagen de cámara, o en el suelo en la vista de pájaro</translation>
    </message>
    <message>
        <source>Remove this person</source>
        <translation>Quitar a esta persona</translation>
    </message>
    <message>
        <source>The person chosen in the table is not there</source>
        <translation>La persona elegida en la tabla no está</translation>
    </message>
    <message>
        <source>Show volumes of people</source>
        <translation>Mostrar volúmenes de las personas</translation>
    </message>
    <message>
        <source>Show the hull that holds 95 % of each person, and the density of each on the floor</source>
        <translation>Mostrar la envolvente que contiene el 95 % de cada persona y su densidad en el suelo</translation>
    </message>
    <message>
        <source>Filter threads…</source>
        <translation>Hilos del filtro…</translation>
    </message>
    <message>
        <source>Choose how many threads share the work of the filter</source>
        <translation>Elegir cuántos hilos se reparten el trabajo del filtro</translation>
    </message>
    <message>
        <source>It is here</source>
        <translation>Está aquí</translation>
    </message>
    <message>
        <source>Drag a target in the camera images to where it is in the frame shown: tracking goes on from there</source>
        <translation>Arrastrar un objetivo en las imágenes de las cámaras adonde está en el fotograma mostrado: el seguimiento continúa desde ahí</translation>
    </message>
    <message>
        <source>Remove the correction</source>
        <translation>Quitar la corrección</translation>
    </message>
    <message>
        <source>Take away where you said that the selected target is in the frame shown; without a selected target, of all</source>
        <translation>Quitar dónde dijo que está el objetivo elegido en el fotograma mostrado; sin objetivo elegido, de todos</translation>
    </message>
    <message>
        <source>Show the volume of interest</source>
        <translation>Mostrar el volumen de interés</translation>
    </message>
    <message>
        <source>Show the box in which targets are searched for, in the images and in the bird&apos;s-eye view</source>
        <translation>Mostrar la caja en la que se buscan objetivos, en las imágenes y en la vista de pájaro</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Track again</source>
        <translation>Seguir de nuevo</translation>
    </message>
    <message>
        <source>Track all again that is of earlier settings</source>
        <translation>Seguir de nuevo todo lo obtenido con ajustes anteriores</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Más lento</translation>
    </message>
    <message>
        <source>Play the recording more slowly, down to 1/30</source>
        <translation>Reproducir la grabación más despacio, hasta 1/30</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Más rápido</translation>
    </message>
    <message>
        <source>Play the recording faster, up to eight times</source>
        <translation>Reproducir la grabación más rápido, hasta ocho veces</translation>
    </message>
    <message>
        <source>Normal speed</source>
        <translation>Velocidad normal</translation>
    </message>
    <message>
        <source>Play the recording as fast as it was filmed</source>
        <translation>Reproducir la grabación a la velocidad a la que se filmó</translation>
    </message>
    <message>
        <source>Slowly until it converges</source>
        <translation>Despacio hasta que converja</translation>
    </message>
    <message>
        <source>Play the first iterations of a run one by one, until every target is held (five seconds at most)</source>
        <translation>Reproducir una a una las primeras iteraciones de una ejecución, hasta que todos los objetivos estén seguidos (cinco segundos como máximo)</translation>
    </message>
    <message>
        <source>Show magnifier</source>
        <translation>Mostrar lupa</translation>
    </message>
    <message>
        <source>Enlarge the particles of a target in a corner of the image where they are too close together to be seen</source>
        <translation>Ampliar en una esquina de la imagen las partículas de un objetivo donde están demasiado juntas para verse</translation>
    </message>
    <message>
        <source>Show lines of sight</source>
        <translation>Mostrar líneas de visión</translation>
    </message>
    <message>
        <source>Draw a line in the bird&apos;s-eye view from each camera to the target: broken where it is hidden from the camera</source>
        <translation>Dibujar en la vista de pájaro una línea de cada cámara al objetivo: discontinua si está oculto para la cámara</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Acercar</translation>
    </message>
    <message>
        <source>Enlarge the camera image under the pointer, or that of the selected camera (the wheel does the same)</source>
        <translation>Ampliar la imagen de cámara bajo el puntero, o la de la cámara elegida (la rueda hace lo mismo)</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Alejar</translation>
    </message>
    <message>
        <source>Show more of the camera image under the pointer, or of that of the selected camera</source>
        <translation>Mostrar más de la imagen de cámara bajo el puntero, o de la de la cámara elegida</translation>
    </message>
    <message>
        <source>Fit image</source>
        <translation>Ajustar imagen</translation>
    </message>
    <message>
        <source>Show all of the camera image again (double click does the same)</source>
        <translation>Mostrar de nuevo toda la imagen de cámara (doble clic hace lo mismo)</translation>
    </message>
    <message>
        <source>Top view</source>
        <translation>Vista desde arriba</translation>
    </message>
    <message>
        <source>Front view</source>
        <translation>Vista desde el frente</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vista 3D</translation>
    </message>
    <message>
        <source>Bird&apos;s-eye view in perspective, free to orbit</source>
        <translation>Vista de pájaro en perspectiva, con giro libre</translation>
    </message>
    <message>
        <source>Fit everything in view</source>
        <translation>Ajustar todo a la vista</translation>
    </message>
    <message>
        <source>Show the whole room in the bird&apos;s-eye view again (double click does the same)</source>
        <translation>Mostrar de nuevo toda la sala en la vista de pájaro (doble clic hace lo mismo)</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Restablecer la disposición</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Pantalla completa</translation>
    </message>
    <message>
        <source>Let the window fill the screen, or give it its frame back</source>
        <translation>Hacer que la ventana llene la pantalla o devolverle su marco</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Según el sistema</translation>
    </message>
    <message>
        <source>Plot position</source>
        <translation>Mostrar posición</translation>
    </message>
    <message>
        <source>Position along x, y and z with a band of two standard deviations, and the truth where it is known</source>
        <translation>Posición en x, y y z con una banda de dos desviaciones típicas, y la verdad donde se conoce</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
    <message>
        <source>Open the manual at the page of the view that is in use</source>
        <translation>Abrir el manual en la página de la vista en uso</translation>
    </message>
    <message>
        <source>Quick start</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>What you see in the window, and how to begin in five steps</source>
        <translation>Qué se ve en la ventana y cómo empezar en cinco pasos</translation>
    </message>
    <message>
        <source>Legend of the overlays</source>
        <translation>Leyenda de los signos</translation>
    </message>
    <message>
        <source>What crosses, ellipses and dots in the images mean</source>
        <translation>Qué significan las cruces, elipses y puntos en las imágenes</translation>
    </message>
    <message>
        <source>About the methods</source>
        <translation>Acerca de los métodos</translation>
    </message>
    <message>
        <source>Open the reference of the tracking methods</source>
        <translation>Abrir la referencia de los métodos de seguimiento</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Informar de un problema…</translation>
    </message>
    <message>
        <source>Collect what helps to find a fault, ready to be copied</source>
        <translation>Reunir lo que ayuda a encontrar un fallo, listo para copiar</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Acerca de Dewpoint</translation>
    </message>
    <message>
        <source>Version, license, and how to cite Dewpoint</source>
        <translation>Versión, licencia y cómo citar Dewpoint</translation>
    </message>
    <message>
        <source>Show images in the bird&apos;s-eye view</source>
        <translation>Mostrar las imágenes en la vista de pájaro</translation>
    </message>
    <message>
        <source>Show what each camera sees, in the bird&apos;s-eye view, on the pyramid it looks through</source>
        <translation>Mostrar en la vista de pájaro lo que ve cada cámara, sobre la pirámide por la que mira</translation>
    </message>
</context>
<context>
    <name>AssessedRegions</name>
    <message>
        <source>matches too</source>
        <translation>también coincide</translation>
    </message>
    <message>
        <source>also the target (Alt-click if not)</source>
        <translation>también el objetivo (si no, Alt+clic)</translation>
    </message>
</context>
<context>
    <name>BoardText</name>
    <message>
        <source>%1: rms %2, focal length %3, %4 pictures; known to %5</source>
        <translation>%1: rms %2, distancia focal %3, %4 imágenes; conocido con %5</translation>
    </message>
    <message>
        <source>Corners in only %1 % of its image: show the board in all of it, also tilted.</source>
        <translation>Esquinas en solo el %1 % de la imagen: muestre el tablero por toda ella, también inclinado.</translation>
    </message>
    <message>
        <source>%1 keeps its place: it never saw the board.</source>
        <translation>%1 conserva su posición: nunca vio el tablero.</translation>
    </message>
    <message>
        <source>%1: rms %2</source>
        <translation>%1: rms %2</translation>
    </message>
    <message>
        <source>, place ±%1, direction ±%2</source>
        <translation>, posición ±%1, dirección ±%2</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>%1 keeps its lens: %2</source>
        <translation>%1 conserva su objetivo: %2</translation>
    </message>
    <message>
        <source>Places: rms %1 over %2 positions of the board</source>
        <translation>Posiciones: rms %1 en %2 lugares del tablero</translation>
    </message>
    <message>
        <source>upper left</source>
        <translation>arriba a la izquierda</translation>
    </message>
    <message>
        <source>top</source>
        <translation>arriba</translation>
    </message>
    <message>
        <source>upper right</source>
        <translation>arriba a la derecha</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>centro</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>lower left</source>
        <translation>abajo a la izquierda</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>abajo</translation>
    </message>
    <message>
        <source>lower right</source>
        <translation>abajo a la derecha</translation>
    </message>
    <message>
        <source>its left side nearer</source>
        <translation>con el lado izquierdo más cerca</translation>
    </message>
    <message>
        <source>its right side nearer</source>
        <translation>con el lado derecho más cerca</translation>
    </message>
    <message>
        <source>its upper side nearer</source>
        <translation>con el lado superior más cerca</translation>
    </message>
    <message>
        <source>its lower side nearer</source>
        <translation>con el lado inferior más cerca</translation>
    </message>
    <message>
        <source>facing the camera</source>
        <translation>de frente a la cámara</translation>
    </message>
    <message>
        <source>No image yet</source>
        <translation>Aún sin imagen</translation>
    </message>
    <message>
        <source>Show it the whole board</source>
        <translation>Muéstrele el tablero entero</translation>
    </message>
    <message>
        <source>Move the board to: %1</source>
        <translation>Mueva el tablero a: %1</translation>
    </message>
    <message>
        <source>Tilt it, %1</source>
        <translation>Inclínelo, %1</translation>
    </message>
    <message>
        <source>Come nearer with the board</source>
        <translation>Acérquese con el tablero</translation>
    </message>
    <message>
        <source>Hold it still</source>
        <translation>Manténgalo quieto</translation>
    </message>
    <message>
        <source>The image is soft: focus, or more light</source>
        <translation>La imagen está borrosa: enfoque o más luz</translation>
    </message>
    <message>
        <source>✓ Done</source>
        <translation>✓ Listo</translation>
    </message>
    <message>
        <source>✓ All cameras have seen enough together</source>
        <translation>✓ Todas las cámaras han visto bastante juntas</translation>
    </message>
    <message>
        <source>Show the board to %1 and %2 at once, hold it still, then elsewhere</source>
        <translation>Muestre el tablero a %1 y %2 a la vez, quieto, y luego en otro lugar</translation>
    </message>
    <message>
        <source>no board in sight</source>
        <translation>ningún tablero a la vista</translation>
    </message>
    <message>
        <source>⚠ soft, edges of %1</source>
        <translation>⚠ borroso, bordes de %1</translation>
    </message>
    <message>
        <source>sharp, edges of %1</source>
        <translation>nítido, bordes de %1</translation>
    </message>
    <message>
        <source>%1 of at least %2 views</source>
        <translation>%1 de al menos %2 vistas</translation>
    </message>
    <message>
        <source>%1 views, known to %2 (wanted: %3)</source>
        <translation>%1 vistas, conocido con %2 (deseado: %3)</translation>
    </message>
    <message>
        <source>● sees the board</source>
        <translation>● ve el tablero</translation>
    </message>
    <message>
        <source>○ does not see the board</source>
        <translation>○ no ve el tablero</translation>
    </message>
    <message>
        <source>%1 views, place known to %2</source>
        <translation>%1 vistas, posición conocida con %2</translation>
    </message>
    <message>
        <source>%1 views with others</source>
        <translation>%1 vistas con otras</translation>
    </message>
    <message>
        <source>The places were not found: %1</source>
        <translation>No se hallaron las posiciones: %1</translation>
    </message>
    <message>
        <source>How good it is cannot be said: too few places were seen by two cameras.</source>
        <translation>No se puede decir qué tan buena es: dos cámaras vieron muy pocos lugares.</translation>
    </message>
</context>
<context>
    <name>CalibrationFiles</name>
    <message>
        <source>Calibrations (%1)</source>
        <translation>Calibraciones (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>CalibrationText</name>
    <message>
        <source>Everything fits when %1 and %2 are exchanged: their videos are likely swapped. Exchange the two files.</source>
        <translation>Todo encaja al intercambiar %1 y %2: probablemente sus vídeos están cambiados. Intercambie los dos archivos.</translation>
    </message>
    <message>
        <source>%1 fits when its video is shifted: it likely shows everything %2 frames late. Synchronize the videos, or let time offsets be found.</source>
        <translation>%1 encaja si se desplaza su vídeo: probablemente muestra todo %2 fotogramas tarde. Sincronice los vídeos o haga que se busquen los desfases.</translation>
    </message>
    <message>
        <source>%1 fits when its video is shifted: it likely shows everything %2 frames early. Synchronize the videos, or let time offsets be found.</source>
        <translation>%1 encaja si se desplaza su vídeo: probablemente muestra todo %2 fotogramas antes. Sincronice los vídeos o haga que se busquen los desfases.</translation>
    </message>
    <message>
        <source>%1 fits one place before %2 and another after: it was likely moved or bumped then. Calibrate with the part after it.</source>
        <translation>%1 encaja en un lugar antes de %2 y en otro después: probablemente se movió o recibió un golpe. Calibre con la parte posterior.</translation>
    </message>
    <message>
        <source>%1 fits only with flipped images: its video is likely mirrored or upside down. Set how its images are turned and mirrored.</source>
        <translation>%1 solo encaja con las imágenes volteadas: su vídeo probablemente está reflejado o boca abajo. Indique cómo se giran y reflejan sus imágenes.</translation>
    </message>
    <message>
        <source>%1 fits with a focal length %2 times the given one: its zoom (or a crop) was likely changed. Calibrate its lens again.</source>
        <translation>%1 encaja con una distancia focal %2 veces la indicada: probablemente cambió su zoom (o un recorte). Calibre de nuevo su objetivo.</translation>
    </message>
    <message>
        <source>The lens data of %1 are likely for another resolution: its images are %2 times as large. Convert them, or record at the calibrated size.</source>
        <translation>Los datos del objetivo de %1 son probablemente de otra resolución: sus imágenes son %2 veces mayores. Conviértalos o grabe con el tamaño calibrado.</translation>
    </message>
    <message>
        <source>In this volume ±%1 (95 %)</source>
        <translation>En este volumen ±%1 (95 %)</translation>
    </message>
    <message>
        <source>, scale ±%1 %</source>
        <translation>, escala ±%1 %</translation>
    </message>
    <message>
        <source>, scale unknown</source>
        <translation>, escala desconocida</translation>
    </message>
    <message>
        <source>, up ±%1</source>
        <translation>, vertical ±%1</translation>
    </message>
    <message>
        <source>, up not measured</source>
        <translation>, vertical sin medir</translation>
    </message>
    <message>
        <source>all cameras</source>
        <translation>todas las cámaras</translation>
    </message>
    <message>
        <source>The cameras would all look at the back of the board or floor: its points are likely mirrored. Check the direction of its axes, and that the print is not reversed.</source>
        <translation>Todas las cámaras mirarían el reverso del tablero o del suelo: probablemente sus puntos están reflejados. Compruebe la dirección de los ejes y que la impresión no esté invertida.</translation>
    </message>
    <message>
        <source>The given length is %1 times what the cameras see: millimeters and meters are likely mixed up.</source>
        <translation>La longitud indicada es %1 veces la que ven las cámaras: probablemente se confundieron milímetros y metros.</translation>
    </message>
    <message>
        <source>The given length is %1 times what the cameras see: it is likely in inches (1 inch = 2.54 cm).</source>
        <translation>La longitud indicada es %1 veces la que ven las cámaras: probablemente está en pulgadas (1 pulgada = 2,54 cm).</translation>
    </message>
    <message>
        <source>The corners form a board with %1 in a row: the number of squares is likely wrong. Count them and correct the board.</source>
        <translation>Las esquinas forman un tablero con %1 por fila: el número de casillas probablemente es erróneo. Cuéntelas y corrija el tablero.</translation>
    </message>
    <message>
        <source>The board&apos;s squares are given %1 times as large as the cameras see them: measure a row with a ruler (prints are often rescaled).</source>
        <translation>Las casillas del tablero se indicaron %1 veces mayores de lo que ven las cámaras: mida una fila con una regla (las impresiones suelen cambiar de escala).</translation>
    </message>
    <message>
        <source>The images fit when shifted by %1 along both axes: a program likely counts pixels from their corners. Convert the principal points.</source>
        <translation>Las imágenes encajan desplazadas %1 en ambos ejes: algún programa cuenta los píxeles desde sus esquinas. Convierta los puntos principales.</translation>
    </message>
</context>
<context>
    <name>CameraAgreement</name>
    <message>
        <source>millimeters</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped, or %3 and %4.</source>
        <translation>%1 y %2 parecen estar intercambiadas, o bien %3 y %4.</translation>
    </message>
    <message>
        <source>%1 and %2 seem to be swapped.</source>
        <translation>%1 y %2 parecen estar intercambiadas.</translation>
    </message>
    <message>
        <source>%1 or %2 looks at least %3 away from its calibration.</source>
        <translation>%1 o %2 mira al menos %3 fuera de su calibración.</translation>
    </message>
    <message>
        <source>%1 looks about %2 away from its calibration.</source>
        <translation>%1 mira unos %2 fuera de su calibración.</translation>
    </message>
    <message>
        <source>%1 and %2 do not see the target at one position. Calibrate them again.</source>
        <translation>%1 y %2 no ven el objetivo en la misma posición. Calíbrelas de nuevo.</translation>
    </message>
    <message>
        <source>%1 does not agree with the other cameras. Calibrate it again.</source>
        <translation>%1 no concuerda con las demás cámaras. Calíbrela de nuevo.</translation>
    </message>
    <message>
        <source>%1 is about %2 late.</source>
        <translation>%1 lleva un retraso de unos %2.</translation>
    </message>
    <message>
        <source>%1 is about %2 early.</source>
        <translation>%1 lleva un adelanto de unos %2.</translation>
    </message>
    <message>
        <source>The calibration seems to be in %1.</source>
        <translation>La calibración parece estar en %1.</translation>
    </message>
    <message>
        <source>%1 and %2 have the same pose.</source>
        <translation>%1 y %2 tienen la misma pose.</translation>
    </message>
    <message>
        <source>Swap %1 and %2</source>
        <translation>Intercambiar %1 y %2</translation>
    </message>
    <message>
        <source>Set the delay of %1</source>
        <translation>Ajustar el retraso de %1</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>Girar %1</translation>
    </message>
    <message>
        <source>Convert to meters</source>
        <translation>Convertir a metros</translation>
    </message>
</context>
<context>
    <name>CameraMotion</name>
    <message>
        <source>turned by %1</source>
        <translation>girada %1</translation>
    </message>
</context>
<context>
    <name>CameraNames</name>
    <message>
        <source>camera %1</source>
        <translation>cámara %1</translation>
    </message>
</context>
<context>
    <name>CameraView</name>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
</context>
<context>
    <name>ClickRadiusText</name>
    <message>
        <source>Its radius seems to be about %1.</source>
        <translation>Su radio parece ser de unos %1.</translation>
    </message>
    <message>
        <source>Its radius seems to be about %1, but %2 is given. Is that its diameter?</source>
        <translation>Su radio parece ser de unos %1, pero se indicó %2. ¿Es ese su diámetro?</translation>
    </message>
    <message>
        <source>Its radius seems to be about %1, but %2 is given.</source>
        <translation>Su radio parece ser de unos %1, pero se indicó %2.</translation>
    </message>
    <message>
        <source>This is a part of something larger of its color: it is followed as a ball with a radius of %1, from where it was marked.</source>
        <translation>Es una parte de algo más grande de su color: se sigue como una bola con un radio de %1, desde donde se marcó.</translation>
    </message>
</context>
<context>
    <name>ColorLearner</name>
    <message>
        <source>target %1</source>
        <translation>objetivo %1</translation>
    </message>
</context>
<context>
    <name>ColorText</name>
    <message>
        <source>at the top left</source>
        <translation>arriba a la izquierda</translation>
    </message>
    <message>
        <source>at the top</source>
        <translation>arriba</translation>
    </message>
    <message>
        <source>at the top right</source>
        <translation>arriba a la derecha</translation>
    </message>
    <message>
        <source>at the left</source>
        <translation>a la izquierda</translation>
    </message>
    <message>
        <source>in the middle</source>
        <translation>en el centro</translation>
    </message>
    <message>
        <source>at the right</source>
        <translation>a la derecha</translation>
    </message>
    <message>
        <source>at the bottom left</source>
        <translation>abajo a la izquierda</translation>
    </message>
    <message>
        <source>at the bottom</source>
        <translation>abajo</translation>
    </message>
    <message>
        <source>at the bottom right</source>
        <translation>abajo a la derecha</translation>
    </message>
    <message>
        <source>Stands out well: %1 of 100.</source>
        <translation>Destaca bien: %1 de 100.</translation>
    </message>
    <message>
        <source>Stands out: %1 of 100.</source>
        <translation>Destaca: %1 de 100.</translation>
    </message>
    <message>
        <source>Hard to tell apart: %1 of 100.</source>
        <translation>Difícil de distinguir: %1 de 100.</translation>
    </message>
    <message>
        <source>Hardly stands out: %1 of 100.</source>
        <translation>Apenas destaca: %1 de 100.</translation>
    </message>
    <message>
        <source>black</source>
        <translation>negro</translation>
    </message>
    <message>
        <source>gray</source>
        <translation>gris</translation>
    </message>
    <message>
        <source>white</source>
        <translation>blanco</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>marrón</translation>
    </message>
    <message>
        <source>red</source>
        <translation>rojo</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>naranja</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>amarillo</translation>
    </message>
    <message>
        <source>green</source>
        <translation>verde</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>turquesa</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>azul</translation>
    </message>
    <message>
        <source>purple</source>
        <translation>morado</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>rosa</translation>
    </message>
    <message>
        <source>Much of the target does not match: Shift-click its light and its dark side.</source>
        <translation>Gran parte del objetivo no coincide: Mayús-clic en su lado claro y en su lado oscuro.</translation>
    </message>
    <message>
        <source>Alt-click what matches too: it can be told apart.</source>
        <translation>Alt-clic en lo que también coincide: se puede distinguir.</translation>
    </message>
    <message>
        <source>Cover what has the same color, or take it out of view.</source>
        <translation>Cubra lo que tiene el mismo color o sáquelo de la imagen.</translation>
    </message>
    <message>
        <source>The target is nearly black here: more light would help.</source>
        <translation>El objetivo es casi negro aquí: más luz ayudaría.</translation>
    </message>
    <message>
        <source>The target is nearly white here: a shorter exposure would help.</source>
        <translation>El objetivo es casi blanco aquí: una exposición más corta ayudaría.</translation>
    </message>
    <message>
        <source>The target is nearly gray: a stronger color would help.</source>
        <translation>El objetivo es casi gris: un color más vivo ayudaría.</translation>
    </message>
    <message>
        <source>This fills much of the image: click the thing itself, or drag a box on it.</source>
        <translation>Esto llena gran parte de la imagen: haz clic en la cosa misma o arrastra un recuadro sobre ella.</translation>
    </message>
    <message>
        <source>%1 % of the images match. Shift-click the target to learn how well it stands out.</source>
        <translation>Coincide el %1 % de las imágenes. Mayús-clic en el objetivo para saber cuánto destaca.</translation>
    </message>
    <message>
        <source>%1 % of the background matches too.</source>
        <translation>El %1 % del fondo también coincide.</translation>
    </message>
    <message>
        <source>One sample hardly matches the learned color: much around it looks the same, or it shows something else.</source>
        <translation>Una muestra apenas encaja con lo aprendido: lo que hay alrededor también tiene su color, o muestra otra cosa.</translation>
    </message>
    <message>
        <source>Something %1 %2 of %3 matches too.</source>
        <translation>Algo %1 %2 de %3 también coincide.</translation>
    </message>
    <message>
        <source>Several things have this color: another one would help.</source>
        <translation>Varias cosas tienen este color: otro ayudaría.</translation>
    </message>
    <message>
        <source>Only a speck was clicked: drag a box on the whole thing.</source>
        <translation>El clic dio solo en una mota: arrastra un recuadro sobre la cosa entera.</translation>
    </message>
    <message>
        <source>Only %1 % of the target and %2 % of the background match.</source>
        <translation>Solo coinciden el %1 % del objetivo y el %2 % del fondo.</translation>
    </message>
    <message>
        <source>A range for all of the target would match %1 % of the background.</source>
        <translation>Un rango para todo el objetivo coincidiría con el %1 % del fondo.</translation>
    </message>
    <message numerus="yes">
        <source>%n things have this color and size: follow all of them, or cover the others.</source>
        <translation>
            <numerusform>%n cosa tiene este color y tamaño: sígala o cubra las otras.</numerusform>
            <numerusform>%n cosas tienen este color y tamaño: siga todas o cubra las otras.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Convergence</name>
    <message>
        <source>Convergence</source>
        <translation>Convergencia</translation>
    </message>
    <message>
        <source>spread</source>
        <translation>dispersión</translation>
    </message>
    <message>
        <source>Convergence in frame %1 (%2)</source>
        <comment>number of a frame, unit</comment>
        <translation>Convergencia en el fotograma %1 (%2)</translation>
    </message>
    <message>
        <source>Spread of the particles after each iteration on this frame. The filter has converged where the curve levels off.</source>
        <translation>Dispersión de las partículas tras cada iteración en este fotograma. El filtro ha convergido donde la curva se aplana.</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>cannot be written</source>
        <translation>no se puede escribir</translation>
    </message>
    <message>
        <source>does not fit the rest</source>
        <translation>no concuerda con lo demás</translation>
    </message>
    <message>
        <source>ended before its announced end</source>
        <translation>terminó antes del final anunciado</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>ha fallado</translation>
    </message>
    <message>
        <source>not a usable value</source>
        <translation>valor no utilizable</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>detenido a petición</translation>
    </message>
    <message>
        <source>the camera cannot be opened</source>
        <translation>no se puede abrir la cámara</translation>
    </message>
    <message>
        <source>the camera stopped delivering images</source>
        <translation>la cámara dejó de entregar imágenes</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>no se puede leer el archivo</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>el archivo no existe</translation>
    </message>
    <message>
        <source>the observations do not settle it</source>
        <translation>las observaciones no lo determinan</translation>
    </message>
    <message>
        <source>the text cannot be understood</source>
        <translation>no se entiende el texto</translation>
    </message>
    <message>
        <source>there is nothing of this name</source>
        <translation>no hay nada con este nombre</translation>
    </message>
    <message>
        <source>this key is missing</source>
        <translation>falta esta clave</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>clave desconocida</translation>
    </message>
    <message>
        <source>wrong type of value</source>
        <translation>tipo de valor incorrecto</translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>Barrera et al. 2005, figure 3: the particles projected into both cameras while the cloud finds the ball.</source>
        <translation>Barrera et al. 2005, figura 3: las partículas proyectadas en ambas cámaras mientras la nube encuentra la pelota.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 4: the same cloud from above.</source>
        <translation>Barrera et al. 2005, figura 4: la misma nube desde arriba.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 6: the object jumps 2 m at iteration 30.</source>
        <translation>Barrera et al. 2005, figura 6: el objeto salta 2 m en la iteración 30.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 7: the same for motion sigmas from 0.001 to 0.3 m, as an image.</source>
        <translation>Barrera et al. 2005, figura 7: lo mismo para sigmas de movimiento de 0,001 a 0,3 m, como imagen.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 8: the cloud at six instants, with a small and a large motion sigma.</source>
        <translation>Barrera et al. 2005, figura 8: la nube en seis instantes, con sigma de movimiento pequeña y grande.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: start volume against the share of runs that converge, and starts beyond the ball.</source>
        <translation>Barrera et al. 2005, sección III-B: volumen inicial frente a la proporción de ejecuciones que convergen, e inicios más allá de la pelota.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, section III-B: with one camera the cloud moves away from it.</source>
        <translation>Barrera et al. 2005, sección III-B: con una cámara la nube se aleja de ella.</translation>
    </message>
    <message>
        <source>Barrera et al. 2005, figure 5: where one camera alone finds the color, and why the cloud moves away from it.</source>
        <translation>Barrera et al. 2005, figura 5: dónde encuentra el color una sola cámara y por qué la nube se aleja de ella.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009, figures 1 and 3: what moves in the images of a camera, in pieces, and how likely that makes a person at each pixel.</source>
        <translation>Mohedano et al. 2009, figuras 1 y 3: lo que se mueve en las imágenes de una cámara, a trozos, y lo probable que hace eso a una persona en cada píxel.</translation>
    </message>
    <message>
        <source>Drift along the optical axis</source>
        <translation>Deriva a lo largo del eje óptico</translation>
    </message>
    <message>
        <source>Error after a jump</source>
        <translation>Error tras un salto</translation>
    </message>
    <message>
        <source>Error over iteration and motion sigma</source>
        <translation>Error según la iteración y la sigma de movimiento</translation>
    </message>
    <message>
        <source>Particles from above</source>
        <translation>Partículas desde arriba</translation>
    </message>
    <message>
        <source>Particles in both images</source>
        <translation>Partículas en ambas imágenes</translation>
    </message>
    <message>
        <source>The cloud on its way</source>
        <translation>La nube en camino</translation>
    </message>
    <message>
        <source>Motion masks and motion likelihood</source>
        <translation>Máscaras de movimiento y verosimilitud del movimiento</translation>
    </message>
    <message>
        <source>The cone of one camera</source>
        <translation>El cono de una cámara</translation>
    </message>
    <message>
        <source>Where the cloud may start</source>
        <translation>Dónde puede empezar la nube</translation>
    </message>
    <message>
        <source>Boxes: error, success and precision</source>
        <translation>Recuadros: error, éxito y precisión</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people come and go; how long an estimate belongs to nobody, and how long a person has no estimate.</source>
        <translation>Mohedano et al. 2009: la gente entra y sale; cuánto tiempo una estimación no corresponde a nadie y cuánto tiempo una persona no tiene estimación.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet and walk on; motion alone may confuse them, color keeps them apart when their clothes differ.</source>
        <translation>Mohedano et al. 2009: dos personas se encuentran y siguen; el movimiento solo puede confundirlas, el color las distingue cuando su ropa es distinta.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people meet, stay and go back where they came from.</source>
        <translation>Mohedano et al. 2009: dos personas se encuentran, se paran y vuelven por donde vinieron.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people walk close to each other.</source>
        <translation>Mohedano et al. 2009: dos personas caminan muy juntas.</translation>
    </message>
    <message>
        <source>People side by side</source>
        <translation>Personas una al lado de otra</translation>
    </message>
    <message>
        <source>People who cross</source>
        <translation>Personas que se cruzan</translation>
    </message>
    <message>
        <source>People who enter and leave</source>
        <translation>Personas que entran y salen</translation>
    </message>
    <message>
        <source>People who meet and turn</source>
        <translation>Personas que se encuentran y dan la vuelta</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009, section 4: 100 and 300 particles, method histogram and four trackers of OpenCV on the same clips.</source>
        <translation>Sugandi et al. 2009, sección 4: 100 y 300 partículas, el método histogram y cuatro seguidores de OpenCV en los mismos vídeos.</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: two people far from each other, the easy case, in which no method may mix them up.</source>
        <translation>Mohedano et al. 2009: dos personas lejos una de la otra, el caso fácil, en el que ningún método debe confundirlas.</translation>
    </message>
    <message>
        <source>People who stay apart</source>
        <translation>Personas que se mantienen alejadas</translation>
    </message>
    <message>
        <source>Barrera et al. 2005: a ball in space</source>
        <translation>Barrera et al. 2005: una pelota en el espacio</translation>
    </message>
    <message>
        <source>Sugandi et al. 2009: boxes in one camera</source>
        <translation>Sugandi et al. 2009: recuadros en una cámara</translation>
    </message>
    <message>
        <source>Mohedano et al. 2009: people</source>
        <translation>Mohedano et al. 2009: personas</translation>
    </message>
    <message>
        <source>More scenes of people</source>
        <translation>Más escenas con personas</translation>
    </message>
    <message>
        <source>People of different heights</source>
        <translation>Personas de distinta estatura</translation>
    </message>
    <message>
        <source>A child of 0.9 to 1.3 m, one person of 1.3 to 1.6 m and one of 1.88 to 2 m walk about.</source>
        <translation>Un niño de 0,9 a 1,3 m, una persona de 1,3 a 1,6 m y otra de 1,88 a 2 m caminan por la sala.</translation>
    </message>
    <message>
        <source>People who sit and crouch</source>
        <translation>Personas que se sientan y se agachan</translation>
    </message>
    <message>
        <source>One person sits down on a stool and rises, one crouches and rises, and one walks by.</source>
        <translation>Una persona se sienta en un taburete y se levanta, otra se agacha y se levanta, y otra pasa de largo.</translation>
    </message>
    <message>
        <source>People who carry things</source>
        <translation>Personas que llevan cosas</translation>
    </message>
    <message>
        <source>Two people walk past each other, one with a box before the chest, one with a bag.</source>
        <translation>Dos personas se cruzan, una con una caja ante el pecho y otra con una bolsa.</translation>
    </message>
    <message>
        <source>A crowd</source>
        <translation>Una multitud</translation>
    </message>
    <message>
        <source>Five to eight people mill about for 12 s; their paths may touch and cross.</source>
        <translation>De cinco a ocho personas van y vienen durante 12 s; sus caminos pueden tocarse y cruzarse.</translation>
    </message>
    <message>
        <source>People seen by two cameras</source>
        <translation>Personas que ven dos cámaras</translation>
    </message>
    <message>
        <source>Two people walk past each other, seen by only two of the four cameras.</source>
        <translation>Dos personas se cruzan; solo las ven dos de las cuatro cámaras.</translation>
    </message>
    <message>
        <source>People who come close</source>
        <translation>Personas que se acercan mucho</translation>
    </message>
    <message>
        <source>Two people come within 0.15 to 0.28 m of each other, stand there, and go back.</source>
        <translation>Dos personas se acercan a entre 0,15 y 0,28 m, se paran y vuelven atrás.</translation>
    </message>
    <message>
        <source>Furniture that moves</source>
        <translation>Muebles que se mueven</translation>
    </message>
    <message>
        <source>A cabinet and a stool are moved after the cameras have learned the background.</source>
        <translation>Un armario y un taburete se mueven después de que las cámaras hayan aprendido el fondo.</translation>
    </message>
    <message>
        <source>Clothes like the room</source>
        <translation>Ropa como la sala</translation>
    </message>
    <message>
        <source>Two people in clothes of the colors of walls, furniture and floor walk past each other.</source>
        <translation>Se cruzan dos personas con ropa de los colores de las paredes, los muebles y el suelo.</translation>
    </message>
    <message>
        <source>Patterned clothes</source>
        <translation>Ropa estampada</translation>
    </message>
    <message>
        <source>Two people in striped, checked or blotched shirts walk past each other.</source>
        <translation>Se cruzan dos personas con camisas de rayas, de cuadros o de manchas.</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>CSV, one row per target and time</source>
        <translation>CSV, una fila por objetivo e instante</translation>
    </message>
    <message>
        <source>CSV, one row per time (spreadsheets)</source>
        <translation>CSV, una fila por instante (hojas de cálculo)</translation>
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
        <translation>C3D (captura de movimiento)</translation>
    </message>
    <message>
        <source>NPZ (NumPy)</source>
        <translation>NPZ (NumPy)</translation>
    </message>
    <message>
        <source>VTP (ParaView, paths)</source>
        <translation>VTP (ParaView, trayectorias)</translation>
    </message>
    <message>
        <source>PVD (ParaView, over time)</source>
        <translation>PVD (ParaView, en el tiempo)</translation>
    </message>
    <message>
        <source>JSON lines</source>
        <translation>Líneas JSON</translation>
    </message>
    <message>
        <source>Z points up, axes as in the project</source>
        <translation>Z apunta hacia arriba, ejes como en el proyecto</translation>
    </message>
    <message>
        <source>Y points up: x, y, z are y, z, x of the project</source>
        <translation>Y apunta hacia arriba: x, y, z son y, z, x del proyecto</translation>
    </message>
    <message>
        <source>Lengths in %1, times in s, covariances in %1². %2.</source>
        <translation>Longitudes en %1, tiempos en s, covarianzas en %1². %2.</translation>
    </message>
    <message>
        <source>no gaps</source>
        <translation>sin huecos</translation>
    </message>
    <message>
        <source>%1 places unknown</source>
        <translation>%1 posiciones desconocidas</translation>
    </message>
    <message>
        <source>Targets: %1, rows: %2 at %3 per second, %4.</source>
        <translation>Objetivos: %1, filas: %2 a %3 por segundo, %4.</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Wrote the figure %1.</source>
        <translation>Se escribió la figura %1.</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2 files; the last is %3.</source>
        <translation>Se exportaron %1 filas a %2 archivos; el último es %3.</translation>
    </message>
    <message>
        <source>Exported %1 rows to %2.</source>
        <translation>Se exportaron %1 filas a %2.</translation>
    </message>
</context>
<context>
    <name>GlContext</name>
    <message>
        <source>no OpenGL context can be made on this display</source>
        <translation>no se puede crear un contexto OpenGL en esta pantalla</translation>
    </message>
    <message>
        <source>the OpenGL context cannot be used</source>
        <translation>no se puede usar el contexto OpenGL</translation>
    </message>
    <message>
        <source>OpenGL 3.2 is needed</source>
        <translation>se necesita OpenGL 3.2</translation>
    </message>
</context>
<context>
    <name>HoldState</name>
    <message>
        <source>● held</source>
        <translation>● seguido</translation>
    </message>
    <message>
        <source>○ searching</source>
        <translation>○ buscando</translation>
    </message>
    <message>
        <source>▲ lost</source>
        <translation>▲ perdido</translation>
    </message>
    <message>
        <source>✕ missing</source>
        <translation>✕ ausente</translation>
    </message>
    <message>
        <source>– no images</source>
        <translation>– sin imágenes</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>Aún sin objetivo</translation>
    </message>
    <message>
        <source>– not tracked</source>
        <translation>– sin seguir</translation>
    </message>
    <message>
        <source>◌ hidden</source>
        <translation>◌ oculto</translation>
    </message>
    <message>
        <source>– no box</source>
        <translation>– sin recuadro</translation>
    </message>
    <message>
        <source>◔ learning the room</source>
        <translation>◔ aprende la sala</translation>
    </message>
    <message>
        <source>◌ nobody there</source>
        <translation>◌ nadie</translation>
    </message>
    <message>
        <source>– not there</source>
        <translation>– ausente</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ ambiguo</translation>
    </message>
</context>
<context>
    <name>MapLegend</name>
    <message>
        <source>%1 or more</source>
        <translation>%1 o más</translation>
    </message>
    <message>
        <source>blank: none</source>
        <translation>vacío: ninguna</translation>
    </message>
    <message>
        <source>blank: fewer than two cameras</source>
        <translation>vacío: menos de dos cámaras</translation>
    </message>
    <message>
        <source>Cameras that see it</source>
        <translation>Cámaras que lo ven</translation>
    </message>
    <message>
        <source>Expected error (1 σ)</source>
        <translation>Error esperado (1 σ)</translation>
    </message>
</context>
<context>
    <name>MapOverlay</name>
    <message>
        <source>Cameras that see it: %1</source>
        <translation>Cámaras que lo ven: %1</translation>
    </message>
    <message>
        <source>±%1 (1 σ); cameras that see it: %2</source>
        <translation>±%1 (1 σ); cámaras que lo ven: %2</translation>
    </message>
</context>
<context>
    <name>Method</name>
    <message>
        <source>A box in one video</source>
        <translation>Un recuadro en un vídeo</translation>
    </message>
    <message>
        <source>A particle filter on color histograms</source>
        <translation>Un filtro de partículas sobre histogramas de color</translation>
    </message>
    <message>
        <source>A particle filter on positions</source>
        <translation>Un filtro de partículas sobre posiciones</translation>
    </message>
    <message>
        <source>A plain particle filter on color</source>
        <translation>Un filtro de partículas sencillo sobre el color</translation>
    </message>
    <message>
        <source>Anything colored, in 3D</source>
        <translation>Cualquier cosa de color, en 3D</translation>
    </message>
    <message>
        <source>Anything you draw a box around</source>
        <translation>Cualquier cosa que rodee con un recuadro</translation>
    </message>
    <message>
        <source>Balls, hands, anything colored</source>
        <translation>Pelotas, manos, cualquier cosa de color</translation>
    </message>
    <message>
        <source>Follows its colors and its size, and finds it again after it was hidden.</source>
        <translation>Sigue sus colores y su tamaño, y lo reencuentra tras una ocultación.</translation>
    </message>
    <message>
        <source>For comparison: confuses people who come close.</source>
        <translation>Para comparar: confunde a quienes se acercan.</translation>
    </message>
    <message>
        <source>For comparison: tells people apart by different clothes.</source>
        <translation>Para comparar: distingue a las personas si su ropa es distinta.</translation>
    </message>
    <message>
        <source>For teaching: follows a box in one video.</source>
        <translation>Para enseñar: sigue un recuadro en un vídeo.</translation>
    </message>
    <message>
        <source>For teaching: shows how a particle filter works.</source>
        <translation>Para enseñar: muestra cómo funciona un filtro de partículas.</translation>
    </message>
    <message>
        <source>For teaching: shows how particles follow measurements.</source>
        <translation>Para enseñar: muestra cómo las partículas siguen las medidas.</translation>
    </message>
    <message>
        <source>From papers, for teaching and comparison</source>
        <translation>De artículos, para enseñar y comparar</translation>
    </message>
    <message>
        <source>People by motion alone</source>
        <translation>Personas solo por movimiento</translation>
    </message>
    <message>
        <source>People by motion and color</source>
        <translation>Personas por movimiento y color</translation>
    </message>
    <message>
        <source>People in a room</source>
        <translation>Personas en una sala</translation>
    </message>
    <message>
        <source>People who walk and meet</source>
        <translation>Personas que caminan y se encuentran</translation>
    </message>
    <message>
        <source>Positions on the floor of several people, also in similar clothes.</source>
        <translation>Posiciones en el suelo de varias personas, también con ropa parecida.</translation>
    </message>
    <message>
        <source>The most accurate: decides by itself between a ball and any other shape.</source>
        <translation>El más preciso: decide por sí mismo entre una bola y cualquier otra forma.</translation>
    </message>
</context>
<context>
    <name>MethodObstacle</name>
    <message>
        <source>Needs calibrated cameras.</source>
        <translation>Necesita cámaras calibradas.</translation>
    </message>
    <message>
        <source>Needs at least two cameras.</source>
        <translation>Necesita al menos dos cámaras.</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Half the x size of the box around the start in which particles start evenly spread; 0 starts them all at the same x.</source>
        <translation>Mitad del tamaño en x de la caja alrededor del inicio en la que las partículas empiezan repartidas por igual; con 0 todas empiezan en el mismo x.</translation>
    </message>
    <message>
        <source>Half the y size of the box around the start in which particles start evenly spread; 0 starts them all at the same y.</source>
        <translation>Mitad del tamaño en y de la caja alrededor del inicio en la que las partículas empiezan repartidas por igual; con 0 todas empiezan en el mismo y.</translation>
    </message>
    <message>
        <source>Half the z size of the box around the start in which particles start evenly spread; 0 starts them all at the same z.</source>
        <translation>Mitad del tamaño en z de la caja alrededor del inicio en la que las partículas empiezan repartidas por igual; con 0 todas empiezan en el mismo z.</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis in one iteration: larger follows faster objects and spreads wider.</source>
        <translation>Cuánto se mueven al azar las partículas a lo largo de cada eje en una iteración: un valor mayor sigue objetos más rápidos y dispersa más.</translation>
    </message>
    <message>
        <source>How many filter iterations run on each frame.</source>
        <translation>Cuántas iteraciones del filtro se ejecutan en cada fotograma.</translation>
    </message>
    <message>
        <source>How many particles the filter uses: more follow more surely and cost more time.</source>
        <translation>Cuántas partículas usa el filtro: más siguen con mayor seguridad y cuestan más tiempo.</translation>
    </message>
    <message>
        <source>Iterations per frame</source>
        <translation>Iteraciones por fotograma</translation>
    </message>
    <message>
        <source>Motion sigma</source>
        <translation>Sigma del movimiento</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>Partículas</translation>
    </message>
    <message>
        <source>Start half-size x</source>
        <translation>Semitamaño inicial x</translation>
    </message>
    <message>
        <source>Start half-size y</source>
        <translation>Semitamaño inicial y</translation>
    </message>
    <message>
        <source>Start half-size z</source>
        <translation>Semitamaño inicial z</translation>
    </message>
    <message>
        <source>Start x</source>
        <translation>Inicio x</translation>
    </message>
    <message>
        <source>Start y</source>
        <translation>Inicio y</translation>
    </message>
    <message>
        <source>Start z</source>
        <translation>Inicio z</translation>
    </message>
    <message>
        <source>World x of the place where all particles start.</source>
        <translation>Coordenada x del mundo del lugar donde empiezan todas las partículas.</translation>
    </message>
    <message>
        <source>World y of the place where all particles start.</source>
        <translation>Coordenada y del mundo del lugar donde empiezan todas las partículas.</translation>
    </message>
    <message>
        <source>World z of the place where all particles start.</source>
        <translation>Coordenada z del mundo del lugar donde empiezan todas las partículas.</translation>
    </message>
    <message>
        <source>Acceleration sigma</source>
        <translation>Sigma de la aceleración</translation>
    </message>
    <message>
        <source>Edge of the room in which a target may appear: larger asks for more evidence before a target is believed.</source>
        <translation>Arista del espacio en el que puede aparecer un objetivo: un valor mayor exige más pruebas antes de dar por cierto un objetivo.</translation>
    </message>
    <message>
        <source>Fewest particles</source>
        <translation>Mínimo de partículas</translation>
    </message>
    <message>
        <source>How far the particles may be from the distribution they stand for (Kullback-Leibler distance): smaller takes more particles where they disagree; 0 always takes all of them.</source>
        <translation>Cuánto pueden apartarse las partículas de la distribución que representan (distancia de Kullback-Leibler): un valor menor usa más partículas donde discrepan; 0 las usa siempre todas.</translation>
    </message>
    <message>
        <source>How long a target that no camera can judge is believed to be still there.</source>
        <translation>Cuánto tiempo se da por presente un objetivo que ninguna cámara puede juzgar.</translation>
    </message>
    <message>
        <source>How many particles each target uses at least, when they all agree.</source>
        <translation>Cuántas partículas usa como mínimo cada objetivo, cuando todas coinciden.</translation>
    </message>
    <message>
        <source>How many particles each target uses at most.</source>
        <translation>Cuántas partículas usa como máximo cada objetivo.</translation>
    </message>
    <message>
        <source>How strongly targets speed up, slow down and turn: larger follows abrupt motion, smaller bridges gaps better.</source>
        <translation>Con cuánta fuerza los objetivos aceleran, frenan y giran: un valor mayor sigue movimientos bruscos, uno menor salva mejor las interrupciones.</translation>
    </message>
    <message>
        <source>Sampling error</source>
        <translation>Error de muestreo</translation>
    </message>
    <message>
        <source>Search size</source>
        <translation>Tamaño de búsqueda</translation>
    </message>
    <message>
        <source>Survival time</source>
        <translation>Tiempo de permanencia</translation>
    </message>
    <message>
        <source>Time budget</source>
        <translation>Límite de tiempo</translation>
    </message>
    <message>
        <source>How long one iteration may take: fewer particles are used, and searches are spread over several frames, to keep to it. 0 sets no limit; with a limit a run depends on the speed of the machine and cannot be repeated bit by bit.</source>
        <translation>Cuánto puede durar una iteración: para respetarlo se usan menos partículas y las búsquedas se reparten entre varios fotogramas. 0 no pone límite; con un límite, una ejecución depende de la velocidad del equipo y no se puede repetir bit a bit.</translation>
    </message>
    <message>
        <source>Color adaptation</source>
        <translation>Adaptación del color</translation>
    </message>
    <message>
        <source>How fast a target&apos;s color range follows slow changes of light, as a time constant; only while the target is surely there, and in each camera by itself. 0 keeps the range as it is; 2 is a good value in a room with daylight.</source>
        <translation>Con qué rapidez el rango de color de un objetivo sigue los cambios lentos de luz, como constante de tiempo; solo mientras el objetivo está ahí con seguridad, y en cada cámara por separado. 0 deja el rango como está; 2 es un buen valor en una sala con luz natural.</translation>
    </message>
    <message>
        <source>How far off a measured position is taken to be along each axis: larger trusts the particles more, smaller the measurement.</source>
        <translation>Cuánto se supone que falla una posición medida en cada eje: mayor confía más en las partículas, menor en la medida.</translation>
    </message>
    <message>
        <source>Observation sigma</source>
        <translation>Sigma de observación</translation>
    </message>
    <message>
        <source>Adaptation</source>
        <translation>Adaptación</translation>
    </message>
    <message>
        <source>Aspect sigma</source>
        <translation>Sigma de la proporción</translation>
    </message>
    <message>
        <source>Hidden below</source>
        <translation>Oculto por debajo de</translation>
    </message>
    <message>
        <source>How different from the reference the colors may be (Bhattacharyya distance): smaller trusts the best particles more.</source>
        <translation>Cuánto pueden diferir los colores de la referencia (distancia de Bhattacharyya): un valor menor confía más en las mejores partículas.</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis from image to image, beside going on as before, in sizes of the target.</source>
        <translation>Cuánto se mueven al azar las partículas a lo largo de cada eje de una imagen a otra, además de seguir como antes, en tamaños del objetivo.</translation>
    </message>
    <message>
        <source>How far particles move at random along each axis from image to image, beside going on as before: larger follows sudden motion and spreads wider.</source>
        <translation>Cuánto se mueven al azar las partículas a lo largo de cada eje de una imagen a otra, además de seguir como antes: un valor mayor sigue movimientos repentinos y dispersa más.</translation>
    </message>
    <message>
        <source>How far the target may be from where it was expected, in sizes of the target, before that counts strongly against a place.</source>
        <translation>Cuánto puede alejarse el objetivo de donde se esperaba, en tamaños del objetivo, antes de que eso cuente mucho en contra de un lugar.</translation>
    </message>
    <message>
        <source>How much better a place with more of the target&apos;s colors is held to be.</source>
        <translation>Cuánto mejor se considera un lugar con más colores del objetivo.</translation>
    </message>
    <message>
        <source>How much the proportion of width to height may change from image to image (logarithm); 0 keeps it as it was given.</source>
        <translation>Cuánto puede cambiar la proporción entre anchura y altura de una imagen a otra (logaritmo); 0 la deja como se dio.</translation>
    </message>
    <message>
        <source>How much the size of the box may change from image to image (logarithm); 0 keeps it as it was given.</source>
        <translation>Cuánto puede cambiar el tamaño del recuadro de una imagen a otra (logaritmo); 0 lo deja como se dio.</translation>
    </message>
    <message>
        <source>Jump reach</source>
        <translation>Alcance de los saltos</translation>
    </message>
    <message>
        <source>Jump share</source>
        <translation>Proporción de saltos</translation>
    </message>
    <message>
        <source>Likelihood sigma</source>
        <translation>Sigma de la verosimilitud</translation>
    </message>
    <message>
        <source>Position sigma</source>
        <translation>Sigma de la posición</translation>
    </message>
    <message>
        <source>Scale sigma</source>
        <translation>Sigma de la escala</translation>
    </message>
    <message>
        <source>Share by which the reference colors follow those of the box from image to image; 0 keeps those of the first image.</source>
        <translation>Proporción en que los colores de referencia siguen a los del recuadro de una imagen a otra; 0 conserva los de la primera imagen.</translation>
    </message>
    <message>
        <source>Share of the particles that are tried at other places with the target&apos;s colors.</source>
        <translation>Proporción de partículas que se prueban en otros lugares con los colores del objetivo.</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Nitidez</translation>
    </message>
    <message>
        <source>The target counts as hidden, and is held, where less than this share of its usual colors is found.</source>
        <translation>El objetivo cuenta como oculto, y se mantiene, donde se encuentra menos de esta proporción de sus colores habituales.</translation>
    </message>
    <message>
        <source>1: who is seen by several cameras becomes a person; 0: only people put there by hand.</source>
        <translation>1: quien es visto por varias cámaras pasa a ser una persona; 0: solo personas puestas a mano.</translation>
    </message>
    <message>
        <source>After how long something new that stays counts as background.</source>
        <translation>Tras cuánto tiempo algo nuevo que permanece cuenta como fondo.</translation>
    </message>
    <message>
        <source>Area half size x</source>
        <translation>Zona: semitamaño x</translation>
    </message>
    <message>
        <source>Area half size y</source>
        <translation>Zona: semitamaño y</translation>
    </message>
    <message>
        <source>Area x</source>
        <translation>Zona x</translation>
    </message>
    <message>
        <source>Area y</source>
        <translation>Zona y</translation>
    </message>
    <message>
        <source>Background memory</source>
        <translation>Memoria del fondo</translation>
    </message>
    <message>
        <source>Background model</source>
        <translation>Modelo de fondo</translation>
    </message>
    <message>
        <source>Birth time</source>
        <translation>Tiempo de aparición</translation>
    </message>
    <message>
        <source>Births</source>
        <translation>Apariciones</translation>
    </message>
    <message>
        <source>Body points</source>
        <translation>Puntos del cuerpo</translation>
    </message>
    <message>
        <source>Color noise</source>
        <translation>Ruido de color</translation>
    </message>
    <message>
        <source>Color weight</source>
        <translation>Peso del color</translation>
    </message>
    <message>
        <source>Darkest shadow</source>
        <translation>Sombra más oscura</translation>
    </message>
    <message>
        <source>Evidence per camera</source>
        <translation>Evidencia por cámara</translation>
    </message>
    <message>
        <source>Floor z</source>
        <translation>Suelo z</translation>
    </message>
    <message>
        <source>Half the size of the floor that is watched; who crosses its border has left.</source>
        <translation>Mitad del tamaño del suelo vigilado; quien cruza su borde se ha ido.</translation>
    </message>
    <message>
        <source>Height of a person whose own is not known yet.</source>
        <translation>Estatura de una persona cuya propia aún no se conoce.</translation>
    </message>
    <message>
        <source>Height of the floor in the world frame.</source>
        <translation>Altura del suelo en el sistema del mundo.</translation>
    </message>
    <message>
        <source>How long a person whom no two cameras see is believed to be still there.</source>
        <translation>Cuánto tiempo se da por presente a una persona que no ven dos cámaras.</translation>
    </message>
    <message>
        <source>How long foreground that nobody explains must stay together to become a person.</source>
        <translation>Cuánto tiempo debe permanecer unido un primer plano que nadie explica para ser una persona.</translation>
    </message>
    <message>
        <source>How long the cameras only learn what they usually show, at first; nobody should be there.</source>
        <translation>Cuánto tiempo aprenden las cámaras al principio lo que suelen mostrar; no debe haber nadie.</translation>
    </message>
    <message>
        <source>How many particles each person has.</source>
        <translation>Cuántas partículas tiene cada persona.</translation>
    </message>
    <message>
        <source>How many points stand for the volume of each person.</source>
        <translation>Cuántos puntos representan el volumen de cada persona.</translation>
    </message>
    <message>
        <source>How moving regions are found: 0 one Gaussian per pixel (fast), 1 OpenCV&apos;s MOG2, 2 OpenCV&apos;s KNN.</source>
        <translation>Cómo se hallan las zonas en movimiento: 0 una gaussiana por píxel (rápido), 1 MOG2 de OpenCV, 2 KNN de OpenCV.</translation>
    </message>
    <message>
        <source>How much a camera that sees a whole person says: larger trusts the masks more.</source>
        <translation>Cuánto dice una cámara que ve a una persona entera: un valor mayor confía más en las máscaras.</translation>
    </message>
    <message>
        <source>How much the colors of clothes count beside the masks when people are near each other.</source>
        <translation>Cuánto cuentan los colores de la ropa junto a las máscaras cuando las personas están cerca.</translation>
    </message>
    <message>
        <source>How near the middles of two people can come.</source>
        <translation>Cuánto pueden acercarse los centros de dos personas.</translation>
    </message>
    <message>
        <source>How strongly people speed up, slow down and turn.</source>
        <translation>Con cuánta fuerza las personas aceleran, frenan y giran.</translation>
    </message>
    <message>
        <source>Hue floor</source>
        <translation>Mínimo del tono</translation>
    </message>
    <message>
        <source>Hue sigma</source>
        <translation>Sigma del tono</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>Ancho de imagen</translation>
    </message>
    <message>
        <source>Images are reduced to at most this width before anything else; 0 keeps them as they are.</source>
        <translation>Las imágenes se reducen primero a este ancho como máximo; 0 las deja como están.</translation>
    </message>
    <message>
        <source>Learning time</source>
        <translation>Tiempo de aprendizaje</translation>
    </message>
    <message>
        <source>Least distance</source>
        <translation>Distancia mínima</translation>
    </message>
    <message>
        <source>Least likelihood of a hue (the paper&apos;s h_B): something else may be seen.</source>
        <translation>Verosimilitud mínima de un tono (h_B del artículo): puede verse otra cosa.</translation>
    </message>
    <message>
        <source>Least likelihood of a saturation (the paper&apos;s s_B).</source>
        <translation>Verosimilitud mínima de una saturación (s_B del artículo).</translation>
    </message>
    <message>
        <source>Least likelihood where a camera sees no motion (the paper&apos;s p_B: 0.2).</source>
        <translation>Verosimilitud mínima donde una cámara no ve movimiento (p_B del artículo: 0,2).</translation>
    </message>
    <message>
        <source>Mask smoothing</source>
        <translation>Suavizado de la máscara</translation>
    </message>
    <message>
        <source>Middle of the floor that is watched.</source>
        <translation>Centro del suelo vigilado.</translation>
    </message>
    <message>
        <source>Motion floor</source>
        <translation>Mínimo de movimiento</translation>
    </message>
    <message>
        <source>Position noise</source>
        <translation>Ruido de posición</translation>
    </message>
    <message>
        <source>Saturation floor</source>
        <translation>Mínimo de la saturación</translation>
    </message>
    <message>
        <source>Saturation sigma</source>
        <translation>Sigma de la saturación</translation>
    </message>
    <message>
        <source>Sigma of the Gaussian that smooths the motion masks (the paper: 4 px).</source>
        <translation>Sigma de la gaussiana que suaviza las máscaras de movimiento (en el artículo: 4 px).</translation>
    </message>
    <message>
        <source>Standard deviation of a measured hue, in [0, 1].</source>
        <translation>Desviación típica de un tono medido, en [0, 1].</translation>
    </message>
    <message>
        <source>Standard deviation of a measured saturation, in [0, 1].</source>
        <translation>Desviación típica de una saturación medida, en [0, 1].</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on each component of the velocity, per frame.</source>
        <translation>Desviación típica del ruido en cada componente de la velocidad, por fotograma.</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on each coordinate, per frame.</source>
        <translation>Desviación típica del ruido en cada coordenada, por fotograma.</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on hue and saturation, per frame.</source>
        <translation>Desviación típica del ruido en tono y saturación, por fotograma.</translation>
    </message>
    <message>
        <source>Usual height</source>
        <translation>Estatura habitual</translation>
    </message>
    <message>
        <source>Velocity noise</source>
        <translation>Ruido de velocidad</translation>
    </message>
    <message>
        <source>What is darker than usual by no more than this factor, in the same tint, is a shadow.</source>
        <translation>Lo que es más oscuro de lo habitual en no más de este factor, con el mismo tono, es una sombra.</translation>
    </message>
    <message>
        <source>Calibration error</source>
        <translation>Error de calibración</translation>
    </message>
    <message>
        <source>How far off the directions are in which the cameras see things. The stated uncertainty of a position includes it. 0.25 suits a calibration by hand.</source>
        <translation>Cuánto se desvían las direcciones en las que las cámaras ven las cosas. La incertidumbre indicada de una posición lo incluye. 0,25 es adecuado para una calibración a mano.</translation>
    </message>
    <message>
        <source>How far off the times of the images are. The stated uncertainty of a moving target includes it. 8 suits webcams.</source>
        <translation>Cuánto se desvían los tiempos de las imágenes. La incertidumbre indicada de un objetivo en movimiento lo incluye. 8 es adecuado para cámaras web.</translation>
    </message>
    <message>
        <source>Time error</source>
        <translation>Error de tiempo</translation>
    </message>
</context>
<context>
    <name>ParameterGroup</name>
    <message>
        <source>Area and people</source>
        <translation>Zona y personas</translation>
    </message>
    <message>
        <source>Essential</source>
        <translation>Esencial</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Avanzado</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Medición</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Search and start</source>
        <translation>Búsqueda e inicio</translation>
    </message>
</context>
<context>
    <name>ParameterRow</name>
    <message>
        <source>%1
From %2 to %3%4; default %5%4.</source>
        <translation>%1
De %2 a %3%4; por defecto %5%4.</translation>
    </message>
    <message>
        <source>%1
From %2 to %3%4; what the cameras see unless you change it.</source>
        <translation>%1
De %2 a %3%4; lo que ven las cámaras mientras no lo cambie.</translation>
    </message>
    <message>
        <source>Changed: the default is %1.</source>
        <translation>Cambiado: el valor por defecto es %1.</translation>
    </message>
    <message>
        <source>Reset to %1 (Backspace on the slider)</source>
        <translation>Restablecer a %1 (Retroceso en el deslizador)</translation>
    </message>
</context>
<context>
    <name>People</name>
    <message>
        <source>learning the empty room: %1 % · keep out of view</source>
        <translation>aprendiendo la sala vacía: %1 % · no entre en la imagen</translation>
    </message>
    <message>
        <source>%1 % of the image moves: not looked at</source>
        <translation>se mueve el %1 % de la imagen: no se tiene en cuenta</translation>
    </message>
    <message>
        <source>learning: %1 %</source>
        <translation>aprendiendo: %1 %</translation>
    </message>
</context>
<context>
    <name>PlotAxisStrip</name>
    <message>
        <source>seconds</source>
        <translation>segundos</translation>
    </message>
    <message>
        <source>iteration</source>
        <translation>iteración</translation>
    </message>
</context>
<context>
    <name>PlotFigure</name>
    <message>
        <source>time, s</source>
        <translation>tiempo, s</translation>
    </message>
    <message>
        <source>filter iteration</source>
        <translation>iteración del filtro</translation>
    </message>
    <message>
        <source>Dewpoint plots</source>
        <translation>Gráficos de Dewpoint</translation>
    </message>
</context>
<context>
    <name>PlotQuantity</name>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
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
        <translation>verdad</translation>
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
</context>
<context>
    <name>Reason</name>
    <message>
        <source>no image</source>
        <translation>sin imagen</translation>
    </message>
    <message>
        <source>covered or moved</source>
        <translation>tapada o movida</translation>
    </message>
    <message>
        <source>too dark</source>
        <translation>demasiado oscuro</translation>
    </message>
    <message>
        <source>out of view</source>
        <translation>fuera de la vista</translation>
    </message>
    <message>
        <source>partly hidden</source>
        <translation>parcialmente oculto</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>oculto</translation>
    </message>
    <message>
        <source>at a look-alike</source>
        <translation>en un objeto parecido</translation>
    </message>
    <message>
        <source>%1 beside a look-alike</source>
        <translation>a %1 de un objeto parecido</translation>
    </message>
    <message>
        <source>no color matches</source>
        <translation>ningún color coincide</translation>
    </message>
    <message>
        <source>its color is %1 away</source>
        <translation>su color está a %1</translation>
    </message>
    <message>
        <source>its color, but not its shape</source>
        <translation>su color, pero no su forma</translation>
    </message>
    <message>
        <source>hidden here</source>
        <translation>oculto aquí</translation>
    </message>
    <message>
        <source>not in this picture</source>
        <translation>no está en esta imagen</translation>
    </message>
</context>
<context>
    <name>RunPlots</name>
    <message>
        <source>all cameras</source>
        <translation>todas las cámaras</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Dispersión</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>Tamaño efectivo de la muestra</translation>
    </message>
    <message>
        <source>effective</source>
        <translation>efectivo</translation>
    </message>
    <message>
        <source>particles</source>
        <translation>partículas</translation>
    </message>
    <message>
        <source>Log likelihood</source>
        <translation>Log-verosimilitud</translation>
    </message>
    <message>
        <source>Existence</source>
        <translation>Existencia</translation>
    </message>
    <message>
        <source>Error against truth</source>
        <translation>Error frente a la verdad</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <source>Time per step</source>
        <translation>Tiempo por paso</translation>
    </message>
    <message>
        <source>one iteration</source>
        <translation>una iteración</translation>
    </message>
    <message>
        <source>Similarity</source>
        <translation>Similitud</translation>
    </message>
    <message>
        <source>to the reference</source>
        <translation>con la referencia</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>width</source>
        <translation>anchura</translation>
    </message>
    <message>
        <source>height</source>
        <translation>altura</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Frame %1, %2</source>
        <translation>Fotograma %1, %2</translation>
    </message>
    <message>
        <source>not tracked</source>
        <translation>sin seguimiento</translation>
    </message>
    <message>
        <source>✕ %1</source>
        <translation>✕ %1</translation>
    </message>
    <message>
        <source>history %1 of %2 MB</source>
        <translation>historial %1 de %2 MB</translation>
    </message>
    <message>
        <source>, the last %1</source>
        <translation>, los últimos %1</translation>
    </message>
    <message>
        <source>tracking again: frame %1 of %2 to %3</source>
        <translation>siguiendo de nuevo: fotograma %1 de %2 a %3</translation>
    </message>
    <message>
        <source>✕ cameras</source>
        <translation>✕ cámaras</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>corregido</translation>
    </message>
    <message>
        <source>of earlier settings</source>
        <translation>con ajustes anteriores</translation>
    </message>
    <message>
        <source>How well each target is held appears here when tracking runs.</source>
        <translation>Lo bien que se sigue cada objetivo aparece aquí durante el seguimiento.</translation>
    </message>
</context>
<context>
    <name>TransportBar</name>
    <message>
        <source>Transport</source>
        <translation>Reproducción</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
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
        <translation>tamaños</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>grados</translation>
    </message>
</context>
<context>
    <name>WandSettings</name>
    <message>
        <source>touches the floor</source>
        <translation>toca el suelo</translation>
    </message>
    <message>
        <source>is at the first end of the distance</source>
        <translation>está en el primer extremo de la distancia</translation>
    </message>
    <message>
        <source>is at the second end of the distance</source>
        <translation>está en el segundo extremo de la distancia</translation>
    </message>
    <message>
        <source>begins to fall</source>
        <translation>empieza a caer</translation>
    </message>
    <message>
        <source>still falls</source>
        <translation>todavía cae</translation>
    </message>
    <message>
        <source>Two cameras or more must see the ball.</source>
        <translation>Dos o más cámaras deben ver la pelota.</translation>
    </message>
    <message>
        <source>Learn the color of the ball first: press L and click it in an image.</source>
        <translation>Aprenda primero el color de la pelota: pulse L y haga clic en ella en una imagen.</translation>
    </message>
    <message>
        <source>A stick has two balls of different colors: learn the second one (Shift+L).</source>
        <translation>Una vara tiene dos pelotas de distinto color: aprenda la segunda (Mayús+L).</translation>
    </message>
    <message>
        <source>The two ends of the stick are the same target: choose another.</source>
        <translation>Los dos extremos de la vara son el mismo objetivo: elija otro.</translation>
    </message>
    <message>
        <source>The size is to come from a distance: take the moments at which the ball is at its two ends.</source>
        <translation>El tamaño debe venir de una distancia: tome los momentos en que la pelota está en sus dos extremos.</translation>
    </message>
    <message>
        <source>A fall needs two moments: one at which the ball begins to fall, and one at which it still falls.</source>
        <translation>Una caída necesita dos momentos: uno en que la pelota empieza a caer y otro en que todavía cae.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AboutDialog</name>
    <message>
        <source>Show license</source>
        <translation>Mostrar la licencia</translation>
    </message>
    <message>
        <source>Hide license</source>
        <translation>Ocultar la licencia</translation>
    </message>
    <message>
        <source>About Dewpoint</source>
        <translation>Acerca de Dewpoint</translation>
    </message>
    <message>
        <source>Dewpoint %1</source>
        <translation>Dewpoint %1</translation>
    </message>
    <message>
        <source>Tracks colored objects in 3D, live, from ordinary cameras with particle filters.</source>
        <translation>Sigue objetos de color en 3D, en vivo, desde cámaras corrientes con filtros de partículas.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later (GPL-3.0-or-later), without any warranty.</source>
        <translation>Software libre bajo la GNU General Public License, versión 3 o posterior (GPL-3.0-or-later), sin garantía alguna.</translation>
    </message>
    <message>
        <source>How to cite</source>
        <translation>Cómo citar</translation>
    </message>
    <message>
        <source>Show the whole text of the license, or hide it</source>
        <translation>Mostrar el texto completo de la licencia u ocultarlo</translation>
    </message>
    <message>
        <source>Copy citation</source>
        <translation>Copiar la cita</translation>
    </message>
    <message>
        <source>Copy the line for your list of references</source>
        <translation>Copiar la línea para su lista de referencias</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::AddPersonTool</name>
    <message>
        <source>Click the person</source>
        <translation>Haga clic en la persona</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter says that a person is there</source>
        <translation>Imagen de %1: las flechas mueven una cruz, Intro dice que allí hay una persona</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackgroundImageTaker</name>
    <message>
        <source>“%1” is in this image: where it is now it would be taken for the room. Better show a moment without it.</source>
        <translation>«%1» está en esta imagen: donde está ahora se tomaría por la habitación. Mejor muestra un momento sin él.</translation>
    </message>
    <message>
        <source>Use it all the same</source>
        <translation>Usarla de todos modos</translation>
    </message>
    <message>
        <source>The camera was changed meanwhile: the image is kept as %1, but not used.</source>
        <translation>La cámara se cambió mientras tanto: la imagen se guardó como %1, pero no se usa.</translation>
    </message>
    <message>
        <source>Change empty room</source>
        <translation>Cambiar la sala vacía</translation>
    </message>
    <message>
        <source>The image shown is now the empty room of %1; it is kept as %2.</source>
        <translation>La imagen mostrada es ahora la habitación vacía de %1; se guarda como %2.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BackwardTracker</name>
    <message>
        <source>Correct position</source>
        <translation>Corregir la posición</translation>
    </message>
    <message>
        <source>The target was followed back to frame %1; from there on it is tracked again.</source>
        <translation>El objetivo se siguió hacia atrás hasta el fotograma %1; desde ahí se sigue de nuevo.</translation>
    </message>
    <message>
        <source>Following the target back in time: frame %1.</source>
        <translation>Siguiendo el objetivo hacia atrás: fotograma %1.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BirdsEyeView</name>
    <message>
        <source>Bird&apos;s-eye view</source>
        <translation>Vista de pájaro</translation>
    </message>
    <message>
        <source>The room in 3D: cameras, particles, estimates and their tracks</source>
        <translation>La sala en 3D: cámaras, partículas, estimaciones y sus trayectorias</translation>
    </message>
    <message>
        <source>No 3D: %1</source>
        <translation>Sin 3D: %1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrationPage</name>
    <message>
        <source>Board</source>
        <translation>Tablero</translation>
    </message>
    <message>
        <source>What to find</source>
        <translation>Qué buscar</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Calibrar</translation>
    </message>
    <message>
        <source>Look for the board in the recording, and calibrate the cameras with it; one step that can be undone</source>
        <translation>Buscar el tablero en la grabación y calibrar con él las cámaras; un paso que se puede deshacer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop; the former calibration is kept</source>
        <translation>Detener; se conserva la calibración anterior</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Take the calibration into the project; one step that can be undone</source>
        <translation>Llevar la calibración al proyecto; un paso que se puede deshacer</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Informe…</translation>
    </message>
    <message>
        <source>Save a page with residuals, coverage and errors of all pictures, and open it</source>
        <translation>Guardar y abrir una página con residuos, cobertura y errores de todas las imágenes</translation>
    </message>
    <message>
        <source>How far the calibration is</source>
        <translation>Avance de la calibración</translation>
    </message>
    <message>
        <source>Show a printed board to the cameras: you are told what to show next, and it is taken when you hold it still.</source>
        <translation>Muestre un tablero impreso a las cámaras: se le indica qué mostrar después y se captura cuando lo mantiene quieto.</translation>
    </message>
    <message>
        <source>A recording in which a printed board is shown to the cameras, held still in many places, near and tilted, calibrates them.</source>
        <translation>Una grabación en la que se muestra un tablero impreso a las cámaras, quieto en muchos lugares, cerca e inclinado, las calibra.</translation>
    </message>
    <message>
        <source>Live cameras</source>
        <translation>Cámaras en vivo</translation>
    </message>
    <message>
        <source>This recording</source>
        <translation>Esta grabación</translation>
    </message>
    <message>
        <source>✓ The cameras are calibrated (Ctrl+Z takes it back).</source>
        <translation>✓ Las cámaras están calibradas (Ctrl+Z lo deshace).</translation>
    </message>
    <message>
        <source>Looking for the board: %p %</source>
        <translation>Buscando el tablero: %p %</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Calculando</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Guardar el informe</translation>
    </message>
    <message>
        <source>Page (*.html)</source>
        <translation>Página (*.html)</translation>
    </message>
    <message>
        <source>Use it anyway</source>
        <translation>Usarla de todos modos</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se guardó %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardCalibrator</name>
    <message>
        <source>Stopped: the former calibration is kept.</source>
        <translation>Detenido: se conserva la calibración anterior.</translation>
    </message>
    <message>
        <source>The project has other cameras by now: calibrate again.</source>
        <translation>El proyecto ya tiene otras cámaras: calibre de nuevo.</translation>
    </message>
    <message>
        <source>Calibrate with a board</source>
        <translation>Calibrar con un tablero</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardForm</name>
    <message>
        <source>Print the board</source>
        <translation>Imprimir el tablero</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Tablero de ajedrez</translation>
    </message>
    <message>
        <source>ChArUco (with markers)</source>
        <translation>ChArUco (con marcadores)</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>Tipo de tablero</translation>
    </message>
    <message>
        <source>ChArUco boards may be partly hidden or outside the image; chessboards must be seen whole</source>
        <translation>Los tableros ChArUco pueden verse solo en parte; los de ajedrez deben verse enteros</translation>
    </message>
    <message>
        <source>Squares across, down</source>
        <translation>Casillas a lo ancho y alto</translation>
    </message>
    <message>
        <source>Squares in a row</source>
        <translation>Casillas por fila</translation>
    </message>
    <message>
        <source>All squares of a row, black and white</source>
        <translation>Todas las casillas de una fila, negras y blancas</translation>
    </message>
    <message>
        <source>Squares in a column</source>
        <translation>Casillas por columna</translation>
    </message>
    <message>
        <source>All squares of a column, black and white</source>
        <translation>Todas las casillas de una columna, negras y blancas</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Lado de una casilla</translation>
    </message>
    <message>
        <source>Measured on the print: a long row with a ruler, divided by its squares</source>
        <translation>Medido en la hoja impresa: una fila larga con regla, dividida entre sus casillas</translation>
    </message>
    <message>
        <source>Unit of the sizes</source>
        <translation>Unidad de las medidas</translation>
    </message>
    <message>
        <source>Unit in which the sizes are typed</source>
        <translation>Unidad en la que se escriben las medidas</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>Lado de un marcador</translation>
    </message>
    <message>
        <source>Of the black square around the pattern</source>
        <translation>Del cuadrado negro alrededor del patrón</translation>
    </message>
    <message>
        <source>Dictionary of the markers</source>
        <translation>Diccionario de los marcadores</translation>
    </message>
    <message>
        <source>As the program called it that made it</source>
        <translation>Como lo llamó el programa que lo creó</translation>
    </message>
    <message>
        <source>Even rows of older software</source>
        <translation>Filas pares de programas antiguos</translation>
    </message>
    <message>
        <source>A ChArUco board with an even number of rows from software older than OpenCV 4.6: its first square is white</source>
        <translation>Un tablero ChArUco con un número par de filas de un programa anterior a OpenCV 4.6: su primera casilla es blanca</translation>
    </message>
    <message>
        <source>Black and white exchanged</source>
        <translation>Blanco y negro invertidos</translation>
    </message>
    <message>
        <source>White markers and corners on a black page</source>
        <translation>Marcadores y esquinas blancos sobre una hoja negra</translation>
    </message>
    <message>
        <source>Print this board…</source>
        <translation>Imprimir este tablero…</translation>
    </message>
    <message>
        <source>Write the board as a PDF in its true size, with a bar to check it with a ruler</source>
        <translation>Escribir el tablero como PDF a tamaño real, con una barra para comprobarlo con regla</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>Size of the sheet that is printed on</source>
        <translation>Tamaño de la hoja en que se imprime</translation>
    </message>
    <message>
        <source>%1 × %2 inner corners; for the command line:</source>
        <translation>%1 × %2 esquinas interiores; para la línea de órdenes:</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>Diccionario</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardGoalForm</name>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Lenses and places</source>
        <translation>Objetivos y posiciones</translation>
    </message>
    <message>
        <source>Lenses</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Places of the cameras</source>
        <translation>Posiciones de las cámaras</translation>
    </message>
    <message>
        <source>What is found</source>
        <translation>Lo que se busca</translation>
    </message>
    <message>
        <source>Lenses: how each camera sees, by itself. Places: where the cameras stand, from a board that several of them see at once</source>
        <translation>Objetivos: cómo ve cada cámara por sí sola. Posiciones: dónde están las cámaras, con un tablero que varias ven a la vez</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>Modelo de objetivo</translation>
    </message>
    <message>
        <source>Pinhole, 5 coefficients</source>
        <translation>Estenopeico, 5 coeficientes</translation>
    </message>
    <message>
        <source>Pinhole, 8 coefficients (wide)</source>
        <translation>Estenopeico, 8 coeficientes (gran angular)</translation>
    </message>
    <message>
        <source>Fisheye</source>
        <translation>Ojo de pez</translation>
    </message>
    <message>
        <source>5 for most lenses; 8 for wide ones; fisheye from about 120° on</source>
        <translation>5 para la mayoría; 8 para gran angular; ojo de pez a partir de unos 120°</translation>
    </message>
    <message>
        <source>The board lies on the floor in frame</source>
        <translation>El tablero está en el suelo en el fotograma</translation>
    </message>
    <message>
        <source>That frame makes the world: X along the rows, Y to the upper edge, Z up. Without it the first camera keeps its place</source>
        <translation>Ese fotograma define el mundo: X a lo largo de las filas, Y hacia el borde superior, Z hacia arriba. Sin él, la primera cámara conserva su posición</translation>
    </message>
    <message>
        <source>Frame in which the board lies on the floor</source>
        <translation>Fotograma en que el tablero está en el suelo</translation>
    </message>
    <message>
        <source>Number of the frame</source>
        <translation>Número del fotograma</translation>
    </message>
    <message>
        <source>This one</source>
        <translation>Este</translation>
    </message>
    <message>
        <source>The frame shown</source>
        <translation>El fotograma mostrado</translation>
    </message>
    <message>
        <source>Take the frame that is shown now</source>
        <translation>Tomar el fotograma que se muestra ahora</translation>
    </message>
    <message>
        <source>Enough at</source>
        <translation>Basta con</translation>
    </message>
    <message>
        <source>Accuracy wanted of lenses</source>
        <translation>Precisión deseada de los objetivos</translation>
    </message>
    <message>
        <source>The guidance ends when a ray is known to so many pixels all over the image</source>
        <translation>La guía termina cuando un rayo se conoce con tantos píxeles en toda la imagen</translation>
    </message>
    <message>
        <source>Accuracy wanted of places</source>
        <translation>Precisión deseada de las posiciones</translation>
    </message>
    <message>
        <source>The guidance ends when the place of each camera is known so well</source>
        <translation>La guía termina cuando la posición de cada cámara se conoce así de bien</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoardLive</name>
    <message>
        <source>How long the board was held still before %1</source>
        <translation>Cuánto tiempo se mantuvo quieto el tablero ante %1</translation>
    </message>
    <message>
        <source>Where %1 saw the board</source>
        <translation>Dónde vio %1 el tablero</translation>
    </message>
    <message>
        <source>Filled: the regions and tilts that the board was shown in. Orange: what is asked for. Green: the board as it is seen now</source>
        <translation>Relleno: zonas e inclinaciones en que se mostró el tablero. Naranja: lo que se pide. Verde: el tablero tal como se ve ahora</translation>
    </message>
    <message>
        <source>Capture now</source>
        <translation>Capturar ahora</translation>
    </message>
    <message>
        <source>Take the board as it is shown now, also when it is not held still</source>
        <translation>Tomar el tablero tal como se muestra ahora, aunque no esté quieto</translation>
    </message>
    <message>
        <source>On the floor now</source>
        <translation>Ahora en el suelo</translation>
    </message>
    <message>
        <source>Take the board as it lies on the floor now: it makes the world. X along its rows, Y to its upper edge, Z up</source>
        <translation>Tomar el tablero tal como está ahora en el suelo: define el mundo. X a lo largo de sus filas, Y hacia su borde superior, Z hacia arriba</translation>
    </message>
    <message>
        <source>Next: places</source>
        <translation>Siguiente: posiciones</translation>
    </message>
    <message>
        <source>Leave the lenses as well known as they are, and show the board to several cameras at once</source>
        <translation>Dejar los objetivos como están y mostrar el tablero a varias cámaras a la vez</translation>
    </message>
    <message>
        <source>Calibrate with these views</source>
        <translation>Calibrar con estas vistas</translation>
    </message>
    <message>
        <source>End here: what was taken so far is enough</source>
        <translation>Terminar aquí: basta con lo capturado</translation>
    </message>
    <message>
        <source>Start over</source>
        <translation>Empezar de nuevo</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Look for the board in the live images, and be told what to show</source>
        <translation>Buscar el tablero en las imágenes en vivo e indicar qué mostrar</translation>
    </message>
    <message>
        <source>Waiting for images: are the cameras playing?</source>
        <translation>Esperando imágenes: ¿están en marcha las cámaras?</translation>
    </message>
    <message>
        <source>Show the board to one camera after the other, as each of them asks.</source>
        <translation>Muestre el tablero a una cámara tras otra, como pida cada una.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxExportDialog</name>
    <message>
        <source>Export boxes</source>
        <translation>Exportar recuadros</translation>
    </message>
    <message>
        <source>Two files are written: boxes.csv (a row per target and frame: box, center, similarity, seen or hidden) and boxes_mot.txt (the format of the MOT challenge). All in pixels.</source>
        <translation>Se escriben dos archivos: boxes.csv (una fila por objetivo y fotograma: recuadro, centro, similitud, visto u oculto) y boxes_mot.txt (el formato del MOT Challenge). Todo en píxeles.</translation>
    </message>
    <message>
        <source>How boxes.csv begins</source>
        <translation>Cómo empieza boxes.csv</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Both files go there; it is made if need be</source>
        <translation>Ambos archivos van ahí; se crea si hace falta</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the folder of the files</source>
        <translation>Elegir la carpeta de los archivos</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Write both files (Enter)</source>
        <translation>Escribir ambos archivos (Intro)</translation>
    </message>
    <message>
        <source>Folder of the boxes</source>
        <translation>Carpeta de los recuadros</translation>
    </message>
    <message>
        <source>boxes.csv and boxes_mot.txt are in %1.</source>
        <translation>boxes.csv y boxes_mot.txt están en %1.</translation>
    </message>
    <message>
        <source>The boxes of another export are there already. Replace them?</source>
        <translation>Ya están ahí los recuadros de otra exportación. ¿Reemplazarlos?</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 ya existe; no se escribió nada.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxModel</name>
    <message>
        <source>● held</source>
        <translation>● seguido</translation>
    </message>
    <message>
        <source>◌ hidden</source>
        <translation>◌ oculto</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>tiempo, s</translation>
    </message>
    <message>
        <source>Seconds, of the frame</source>
        <translation>Segundos, del fotograma</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>fotograma</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>Fotograma, contado desde 1</translation>
    </message>
    <message>
        <source>target</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>Nombre del objetivo</translation>
    </message>
    <message>
        <source>x, px</source>
        <translation>x, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the left edge of the image</source>
        <translation>Centro del recuadro, píxeles desde el borde izquierdo de la imagen</translation>
    </message>
    <message>
        <source>y, px</source>
        <translation>y, px</translation>
    </message>
    <message>
        <source>Center of the box, pixels from the upper edge of the image</source>
        <translation>Centro del recuadro, píxeles desde el borde superior de la imagen</translation>
    </message>
    <message>
        <source>width, px</source>
        <translation>anchura, px</translation>
    </message>
    <message>
        <source>Width of the box, pixels</source>
        <translation>Anchura del recuadro, píxeles</translation>
    </message>
    <message>
        <source>height, px</source>
        <translation>altura, px</translation>
    </message>
    <message>
        <source>Height of the box, pixels</source>
        <translation>Altura del recuadro, píxeles</translation>
    </message>
    <message>
        <source>similarity</source>
        <translation>similitud</translation>
    </message>
    <message>
        <source>How alike the colors in the box are to those it was given with, 0 to 1</source>
        <translation>Cuánto se parecen los colores del recuadro a aquellos con los que se dio, de 0 a 1</translation>
    </message>
    <message>
        <source>spread, px</source>
        <translation>dispersión, px</translation>
    </message>
    <message>
        <source>Root mean square distance of the particles to their mean</source>
        <translation>Distancia cuadrática media de las partículas a su media</translation>
    </message>
    <message>
        <source>state</source>
        <translation>estado</translation>
    </message>
    <message>
        <source>Hidden: it is held where it is thought to be</source>
        <translation>Oculto: se mantiene donde se cree que está</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPanel</name>
    <message>
        <source>Boxes of the targets</source>
        <translation>Recuadros de los objetivos</translation>
    </message>
    <message>
        <source>This method follows boxes in images: click the thing or drag a box around it in any camera view. Its box in every frame appears here, in pixels.</source>
        <translation>Este método sigue recuadros en imágenes: haz clic en la cosa o arrastra un recuadro a su alrededor en cualquier cámara. Aquí aparece su recuadro en cada fotograma, en píxeles.</translation>
    </message>
    <message numerus="yes">
        <source>%n boxes, in pixels of the image</source>
        <translation>
            <numerusform>%n recuadro, en píxeles de la imagen</numerusform>
            <numerusform>%n recuadros, en píxeles de la imagen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::BoxPicker</name>
    <message>
        <source>This camera shows no image to take a box from.</source>
        <translation>Esta cámara no muestra ninguna imagen de la que tomar un recuadro.</translation>
    </message>
    <message>
        <source>Box of %1</source>
        <translation>Recuadro de %1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationChoice</name>
    <message>
        <source>Calibration:</source>
        <translation>Calibración:</translation>
    </message>
    <message>
        <source>Choose calibration…</source>
        <translation>Elegir calibración…</translation>
    </message>
    <message>
        <source>A calibration file of Dewpoint or another program; cameras are found by their names, or else taken in its order</source>
        <translation>Un archivo de calibración de Dewpoint o de otro programa; las cámaras se buscan por su nombre o, si no, se toman en el orden del archivo</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Go without a calibration file</source>
        <translation>Sin archivo de calibración</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>Elija una calibración</translation>
    </message>
    <message>
        <source>Recognized: %1. It leaves something open: %2. Create the project without it; then Import calibration asks for what is missing.</source>
        <translation>Reconocido: %1. Deja algo sin definir: %2. Cree el proyecto sin él; después «Importar calibración» pregunta lo que falta.</translation>
    </message>
    <message>
        <source>Recognized: %1. It cannot be used: %2.</source>
        <translation>Reconocido: %1. No se puede usar: %2.</translation>
    </message>
    <message>
        <source>The file cannot be used: %1.</source>
        <translation>El archivo no se puede usar: %1.</translation>
    </message>
    <message>
        <source>Not recognized. Dewpoint reads: %1.</source>
        <translation>No reconocido. Dewpoint lee: %1.</translation>
    </message>
    <message>
        <source>Recognized: %1. Its cameras do not fit those above: %2.</source>
        <translation>Reconocido: %1. Sus cámaras no concuerdan con las de arriba: %2.</translation>
    </message>
    <message numerus="yes">
        <source>✓ Recognized: %1, %n cameras</source>
        <translation>
            <numerusform>✓ Reconocido: %1, %n cámara</numerusform>
            <numerusform>✓ Reconocido: %1, %n cámaras</numerusform>
        </translation>
    </message>
    <message>
        <source>None: camera positions will be a guess</source>
        <translation>Ninguna: las posiciones de las cámaras serán una suposición</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Leyendo…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationDock</name>
    <message>
        <source>Ways to calibrate</source>
        <translation>Formas de calibrar</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationExportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>Elegir una carpeta</translation>
    </message>
    <message>
        <source>Export the calibration</source>
        <translation>Exportar la calibración</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Write the file; one that exists is replaced</source>
        <translation>Escribir el archivo; si existe, se reemplaza</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>The program that is to read the file</source>
        <translation>El programa que leerá el archivo</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Of lengths, where the format leaves it open</source>
        <translation>De las longitudes, si el formato la deja abierta</translation>
    </message>
    <message>
        <source>as usual for the format</source>
        <translation>la habitual del formato</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>%1: largest reprojection difference %2 (fitted anew)</source>
        <translation>%1: mayor diferencia de reproyección %2 (reajustada)</translation>
    </message>
    <message>
        <source>%1: largest reprojection difference %2</source>
        <translation>%1: mayor diferencia de reproyección %2</translation>
    </message>
    <message>
        <source>%1: %2 of 81 directions have no pixel any more</source>
        <translation>%1: %2 de 81 direcciones ya no tienen píxel</translation>
    </message>
    <message>
        <source>%1 exists and will be replaced.</source>
        <translation>%1 existe y será reemplazado.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se guardó %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationImportDialog</name>
    <message>
        <source>Choose a folder</source>
        <translation>Elegir una carpeta</translation>
    </message>
    <message>
        <source>Import a calibration</source>
        <translation>Importar una calibración</translation>
    </message>
    <message>
        <source>as the names say</source>
        <translation>según los nombres</translation>
    </message>
    <message>
        <source>only %1</source>
        <translation>solo %1</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Carpeta…</translation>
    </message>
    <message>
        <source>Find a folder with a file for each camera</source>
        <translation>Buscar una carpeta con un archivo por cámara</translation>
    </message>
    <message>
        <source>Use these cameras</source>
        <translation>Usar estas cámaras</translation>
    </message>
    <message>
        <source>Take the calibration into the project; it can be undone</source>
        <translation>Llevar la calibración al proyecto; se puede deshacer</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>como dice el archivo</translation>
    </message>
    <message>
        <source>recognized from the content</source>
        <translation>reconocido por el contenido</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pies</translation>
    </message>
    <message>
        <source>k1 k2 p1 p2 of a pinhole</source>
        <translation>k1 k2 p1 p2 de una estenopeica</translation>
    </message>
    <message>
        <source>k1 k2 k3 k4 of a fisheye</source>
        <translation>k1 k2 k3 k4 de un ojo de pez</translation>
    </message>
    <message>
        <source>as the format has them</source>
        <translation>como en el formato</translation>
    </message>
    <message>
        <source>camera from world</source>
        <translation>cámara desde mundo</translation>
    </message>
    <message>
        <source>world from camera</source>
        <translation>mundo desde cámara</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>The program that wrote the file</source>
        <translation>El programa que escribió el archivo</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Of lengths in the file; or type the meters of one unit, such as 0.025 for squares of 25 mm</source>
        <translation>De las longitudes del archivo; o escriba los metros de una unidad, como 0.025 para casillas de 25 mm</translation>
    </message>
    <message>
        <source>Four coefficients</source>
        <translation>Cuatro coeficientes</translation>
    </message>
    <message>
        <source>What four lens coefficients mean</source>
        <translation>Qué significan cuatro coeficientes del objetivo</translation>
    </message>
    <message>
        <source>Size of images</source>
        <translation>Tamaño de imagen</translation>
    </message>
    <message>
        <source>Width and height in pixels, such as 1280x720</source>
        <translation>Anchura y altura en píxeles, como 1280x720</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Poses</translation>
    </message>
    <message>
        <source>Which way the poses in the file go</source>
        <translation>En qué sentido van las poses del archivo</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Para</translation>
    </message>
    <message>
        <source>Which camera a file of one camera is about</source>
        <translation>De qué cámara trata un archivo de una sola cámara</translation>
    </message>
    <message>
        <source>The file leaves something open. Answer “%1” above.</source>
        <translation>El archivo deja algo abierto. Responda «%1» arriba.</translation>
    </message>
    <message>
        <source>The calibration names its cameras differently: they were taken in its order.</source>
        <translation>La calibración llama a sus cámaras de otro modo: se tomaron en su orden.</translation>
    </message>
    <message>
        <source>There is no pose in the file: only the lens is taken, the pose stays.</source>
        <translation>No hay pose en el archivo: solo se toma el objetivo, la pose se mantiene.</translation>
    </message>
    <message>
        <source>%1 (in the file: %2): %3 and %4 from where it is now</source>
        <translation>%1 (en el archivo: %2): a %3 y %4 de donde está ahora</translation>
    </message>
    <message>
        <source>Largest reprojection difference to the file: %1</source>
        <translation>Mayor diferencia de reproyección con el archivo: %1</translation>
    </message>
    <message>
        <source>Import calibration</source>
        <translation>Importar calibración</translation>
    </message>
    <message>
        <source>The cameras have the calibration of %1 now.</source>
        <translation>Las cámaras tienen ahora la calibración de %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CalibrationMode</name>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraAgreementAlerts</name>
    <message>
        <source>Calibrate %1…</source>
        <translation>Calibrar %1…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraForm</name>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>The camera that is adjusted; clicking into its image chooses it too</source>
        <translation>La cámara que se ajusta; un clic en su imagen también la elige</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>centimeters</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>Unit of positions</source>
        <translation>Unidad de las posiciones</translation>
    </message>
    <message>
        <source>Unit in which positions are shown and typed</source>
        <translation>Unidad en la que se muestran y escriben las posiciones</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>Mira</translation>
    </message>
    <message>
        <source>at a point, roll</source>
        <translation>a un punto, alabeo</translation>
    </message>
    <message>
        <source>yaw, pitch, roll</source>
        <translation>guiñada, cabeceo, alabeo</translation>
    </message>
    <message>
        <source>How the direction is said</source>
        <translation>Cómo se indica la dirección</translation>
    </message>
    <message>
        <source>A point that the camera looks at, or angles: yaw from x toward y, pitch above the horizon, roll about the line of sight</source>
        <translation>Un punto al que mira la cámara, o ángulos: guiñada de x hacia y, cabeceo sobre el horizonte, alabeo alrededor de la línea de visión</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>focal length</source>
        <translation>distancia focal</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>campo de visión</translation>
    </message>
    <message>
        <source>How the lens is said</source>
        <translation>Cómo se indica el objetivo</translation>
    </message>
    <message>
        <source>Focal length in pixels, or the horizontal field of view in degrees</source>
        <translation>Distancia focal en píxeles, o campo de visión horizontal en grados</translation>
    </message>
    <message>
        <source>Focal length or field of view</source>
        <translation>Distancia focal o campo de visión</translation>
    </message>
    <message>
        <source>How much the camera magnifies; the keys + and − change it too</source>
        <translation>Cuánto aumenta la cámara; las teclas + y − también lo cambian</translation>
    </message>
    <message>
        <source>Dragging</source>
        <translation>Arrastrar</translation>
    </message>
    <message>
        <source>turns the camera</source>
        <translation>gira la cámara</translation>
    </message>
    <message>
        <source>slides the camera</source>
        <translation>desplaza la cámara</translation>
    </message>
    <message>
        <source>What dragging does</source>
        <translation>Qué hace arrastrar</translation>
    </message>
    <message>
        <source>What the camera does while the grid is dragged and nothing is held. Click points of the grid to hold up to three of them.</source>
        <translation>Lo que hace la cámara mientras se arrastra la cuadrícula sin nada sujeto. Haga clic en puntos de la cuadrícula para sujetar hasta tres.</translation>
    </message>
    <message>
        <source>Three held points: the focal length gives way</source>
        <translation>Tres puntos sujetos: cede la distancia focal</translation>
    </message>
    <message>
        <source>Three held points fix the pose; dragging then changes the focal length, and the camera follows</source>
        <translation>Tres puntos sujetos fijan la pose; arrastrar cambia entonces la distancia focal, y la cámara la sigue</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>move</source>
        <translation>mover</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>girar</translation>
    </message>
    <message>
        <source>What keys do</source>
        <translation>Qué hacen las teclas</translation>
    </message>
    <message>
        <source>Arrows or W A S D, with Q and E or the page keys: 1 cm or 0.2° a step. Shift: ten times as much; Ctrl with arrows and page keys: a tenth.</source>
        <translation>Flechas o W A S D, con Q y E o las teclas de página: 1 cm o 0,2° por paso. Mayús: diez veces más; Ctrl con flechas y teclas de página: una décima parte.</translation>
    </message>
    <message>
        <source>as it looks</source>
        <translation>según mira</translation>
    </message>
    <message>
        <source>along x, y, z</source>
        <translation>según x, y, z</translation>
    </message>
    <message>
        <source>Directions of keys</source>
        <translation>Direcciones de las teclas</translation>
    </message>
    <message>
        <source>Right, forward and up as the camera looks, or the axes of the world</source>
        <translation>Derecha, adelante y arriba según mira la cámara, o los ejes del mundo</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Guiñada</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Cabeceo</translation>
    </message>
    <message>
        <source>Position %1</source>
        <translation>Posición %1</translation>
    </message>
    <message>
        <source>Where the camera stands, along %1</source>
        <translation>Dónde está la cámara, según %1</translation>
    </message>
    <message>
        <source>Looks at %1</source>
        <translation>Mira a %1</translation>
    </message>
    <message>
        <source>The point the camera looks at, along %1</source>
        <translation>El punto al que mira la cámara, según %1</translation>
    </message>
    <message>
        <source>Direction from above: 0° along x, 90° along y</source>
        <translation>Dirección desde arriba: 0° según x, 90° según y</translation>
    </message>
    <message>
        <source>Above the horizon; straight down is −90°</source>
        <translation>Sobre el horizonte; vertical hacia abajo es −90°</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>alabeo</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Alabeo</translation>
    </message>
    <message>
        <source>Turned about its line of sight, clockwise</source>
        <translation>Girada alrededor de su línea de visión, en sentido horario</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>looks at</source>
        <translation>mira a</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>guiñada</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>cabeceo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraMotionAlerts</name>
    <message>
        <source>%1 was %2 (frame %3).</source>
        <translation>%1 fue %2 (fotograma %3).</translation>
    </message>
    <message>
        <source>Its new pose is being worked out.</source>
        <translation>Se está calculando su nueva pose.</translation>
    </message>
    <message>
        <source>Its pose can be solved again from what it sees.</source>
        <translation>Su pose puede resolverse de nuevo a partir de lo que ve.</translation>
    </message>
    <message>
        <source>Re-solve %1</source>
        <translation>Resolver de nuevo %1</translation>
    </message>
    <message>
        <source>It cannot be solved again from what it sees: calibrate it anew, or put it back.</source>
        <translation>No puede resolverse de nuevo a partir de lo que ve: calíbrela otra vez o devuélvala a su sitio.</translation>
    </message>
    <message>
        <source>Calibrate %1…</source>
        <translation>Calibrar %1…</translation>
    </message>
    <message>
        <source>%1 stands again as it was calibrated.</source>
        <translation>%1 vuelve a estar como se calibró.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraPanel</name>
    <message>
        <source>Rename camera</source>
        <translation>Renombrar la cámara</translation>
    </message>
    <message>
        <source>Change source of images</source>
        <translation>Cambiar el origen de las imágenes</translation>
    </message>
    <message>
        <source>Turn images</source>
        <translation>Girar las imágenes</translation>
    </message>
    <message>
        <source>Choose a calibration</source>
        <translation>Elija una calibración</translation>
    </message>
    <message>
        <source>Calibrations (*.toml);;All files (*)</source>
        <translation>Calibraciones (*.toml);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Name of the camera, in views and files</source>
        <translation>Nombre de la cámara, en vistas y archivos</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Video file, folder of images, device or address of a stream</source>
        <translation>Archivo de vídeo, carpeta de imágenes, dispositivo o dirección de un flujo</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Find the recording of this camera in another place</source>
        <translation>Buscar la grabación de esta cámara en otro lugar</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Girada</translation>
    </message>
    <message>
        <source>Images are turned clockwise by so much before use</source>
        <translation>Las imágenes se giran tanto en sentido horario antes de usarse</translation>
    </message>
    <message>
        <source>Load calibration…</source>
        <translation>Cargar calibración…</translation>
    </message>
    <message>
        <source>Take the calibration of all cameras from a file</source>
        <translation>Tomar la calibración de todas las cámaras de un archivo</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulada</translation>
    </message>
    <message>
        <source>%1 × %2 pixels, focal length %3 pixels
at %4, %5, %6</source>
        <translation>%1 × %2 píxeles, distancia focal %3 píxeles
en %4, %5, %6</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Elija una carpeta de imágenes</translation>
    </message>
    <message>
        <source>Choose the video of this camera</source>
        <translation>Elija el vídeo de esta cámara</translation>
    </message>
    <message>
        <source>Mirror images</source>
        <translation>Reflejar imágenes</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Reflejada</translation>
    </message>
    <message>
        <source>Images are mirrored left to right, after they were turned</source>
        <translation>Las imágenes se reflejan de izquierda a derecha, tras girarlas</translation>
    </message>
    <message>
        <source>Empty room</source>
        <translation>Sala vacía</translation>
    </message>
    <message>
        <source>Image, video or folder of images in which this camera shows the scene without any target: what has its color there is not taken for it</source>
        <translation>Imagen, vídeo o carpeta de imágenes en que esta cámara muestra la escena sin ningún objetivo: lo que allí tiene su color no se toma por él</translation>
    </message>
    <message>
        <source>Choose the empty room</source>
        <translation>Elegir la sala vacía</translation>
    </message>
    <message>
        <source>Find an image or a video of the scene without any target</source>
        <translation>Buscar una imagen o un vídeo de la escena sin ningún objetivo</translation>
    </message>
    <message>
        <source>Use the image shown</source>
        <translation>Usar la imagen mostrada</translation>
    </message>
    <message>
        <source>Keep the image this camera shows now as the one of the empty room</source>
        <translation>Guardar la imagen que muestra ahora esta cámara como la de la sala vacía</translation>
    </message>
    <message>
        <source>Change empty room</source>
        <translation>Cambiar la sala vacía</translation>
    </message>
    <message>
        <source>Choose an image or a video of the empty room</source>
        <translation>Elegir una imagen o un vídeo de la sala vacía</translation>
    </message>
    <message>
        <source>Change how late the images are</source>
        <translation>Cambiar el retraso de las imágenes</translation>
    </message>
    <message>
        <source>Late by</source>
        <translation>Retraso</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Milliseconds by which its images are late: they are put together with those of the other cameras by it. Calibrate by waving finds it</source>
        <translation>Milisegundos que se retrasan sus imágenes: con ellos se emparejan con las de las demás cámaras. «Calibrar agitando» los encuentra</translation>
    </message>
    <message>
        <source>Milliseconds by which the images are late</source>
        <translation>Milisegundos que se retrasan las imágenes</translation>
    </message>
    <message>
        <source>Load calibration</source>
        <translation>Cargar calibración</translation>
    </message>
    <message>
        <source>The calibration names its cameras differently: they were taken in its order.</source>
        <translation>La calibración llama a sus cámaras de otro modo: se tomaron en su orden.</translation>
    </message>
    <message>
        <source>The cameras have the calibration of %1 now.</source>
        <translation>Las cámaras tienen ahora la calibración de %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraTable</name>
    <message>
        <source>rtsp://192.168.0.10/stream, or a device number such as 0</source>
        <translation>rtsp://192.168.0.10/stream, o un número de dispositivo, como 0</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Leyendo…</translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %3 frames per second · %n frames</source>
        <translation>
            <numerusform>✓ %1×%2 · %3 fotogramas por segundo · %n fotograma</numerusform>
            <numerusform>✓ %1×%2 · %3 fotogramas por segundo · %n fotogramas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>✓ %1×%2 · %n images</source>
        <translation>
            <numerusform>✓ %1×%2 · %n imagen</numerusform>
            <numerusform>✓ %1×%2 · %n imágenes</numerusform>
        </translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Live: tried when the project is made</source>
        <translation>En vivo: se prueba al crear el proyecto</translation>
    </message>
    <message>
        <source>Videos differ in frame rate: frame N of one is not the same moment as frame N of the other.</source>
        <translation>Los vídeos tienen distinta frecuencia de fotogramas: el fotograma N de uno no es el mismo momento que el fotograma N del otro.</translation>
    </message>
    <message numerus="yes">
        <source>Videos differ in length: using the first %n frames.</source>
        <translation>
            <numerusform>Los vídeos tienen distinta duración: se usa el primer fotograma (%n).</numerusform>
            <numerusform>Los vídeos tienen distinta duración: se usan los primeros %n fotogramas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Videos differ in size: each camera keeps its own.</source>
        <translation>Los vídeos tienen distinto tamaño: cada cámara conserva el suyo.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CameraView</name>
    <message>
        <source>This camera delivered no image for this frame.</source>
        <translation>Esta cámara no entregó imagen para este fotograma.</translation>
    </message>
    <message>
        <source>No images yet. Press play (Space), or open a project (Ctrl+O).</source>
        <translation>Aún no hay imágenes. Pulse reproducir (Espacio) o abra un proyecto (Ctrl+O).</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ChangesGuard</name>
    <message>
        <source>Save the project</source>
        <translation>Guardar el proyecto</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml)</source>
        <translation>Proyectos de Dewpoint (*.toml)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se guardó %1.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Save the changes to this project?</source>
        <translation>¿Guardar los cambios de este proyecto?</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorChoice</name>
    <message>
        <source>Color %1</source>
        <translation>Color %1</translation>
    </message>
    <message>
        <source>Show this color, so that its range can be changed by hand</source>
        <translation>Mostrar este color del objetivo, para cambiar su rango a mano</translation>
    </message>
    <message>
        <source>Colors of the target</source>
        <translation>Colores del objetivo</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove this color from the target, and the samples that show it</source>
        <translation>Quitar este color del objetivo, con las muestras que lo enseñan</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorDock</name>
    <message>
        <source>Color</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Take a box here</source>
        <translation>Tomar un recuadro aquí</translation>
    </message>
    <message>
        <source>Learn the color here</source>
        <translation>Aprender el color aquí</translation>
    </message>
    <message>
        <source>Add a sample here</source>
        <translation>Añadir una muestra aquí</translation>
    </message>
    <message>
        <source>This is not the target</source>
        <translation>Esto no es el objetivo</translation>
    </message>
    <message>
        <source>Track this object, starting from a box around it</source>
        <translation>Seguir este objeto, a partir de un recuadro a su alrededor</translation>
    </message>
    <message>
        <source>Learn the target&apos;s color from this spot</source>
        <translation>Aprender el color del objetivo en este punto</translation>
    </message>
    <message>
        <source>Add this color to the target&apos;s (Shift-click does the same)</source>
        <translation>Añadir este color a los del objetivo (Mayús-clic hace lo mismo)</translation>
    </message>
    <message>
        <source>Exclude this color (Alt-click does the same)</source>
        <translation>Excluir este color (Alt-clic hace lo mismo)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorLearner</name>
    <message>
        <source>This camera shows no image to learn from.</source>
        <translation>Esta cámara no muestra ninguna imagen de la que aprender.</translation>
    </message>
    <message>
        <source>Click the target first; then exclude what is not it.</source>
        <translation>Primero haga clic en el objetivo; después excluya lo que no lo es.</translation>
    </message>
    <message>
        <source>Exclude color</source>
        <translation>Excluir color</translation>
    </message>
    <message>
        <source>Add color sample</source>
        <translation>Añadir muestra de color</translation>
    </message>
    <message>
        <source>Learn color</source>
        <translation>Aprender color</translation>
    </message>
    <message>
        <source>Remove color sample</source>
        <translation>Quitar muestra de color</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPanel</name>
    <message>
        <source>Looking at the images…</source>
        <translation>Mirando las imágenes…</translation>
    </message>
    <message>
        <source>No target yet</source>
        <translation>Aún sin objetivo</translation>
    </message>
    <message>
        <source>A new target</source>
        <translation>Un objetivo nuevo</translation>
    </message>
    <message>
        <source>Drag ring and bars, or press Learn and click the target.</source>
        <translation>Arrastre el anillo y las barras, o pulse Aprender y haga clic en el objetivo.</translation>
    </message>
    <message>
        <source>Click the thing to follow in any camera image.</source>
        <translation>Haga clic en cualquier imagen sobre lo que quiere seguir.</translation>
    </message>
    <message>
        <source>Change color range</source>
        <translation>Cambiar el intervalo de color</translation>
    </message>
    <message>
        <source>Click the thing to follow</source>
        <translation>Haz clic en lo que quieras seguir</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it</source>
        <translation>Haz clic en la cosa o arrastra un recuadro a su alrededor</translation>
    </message>
    <message>
        <source>Followed from its box in %1, frame %2: %3 × %4. This method needs no color; press Box and click the thing for another box.</source>
        <translation>Se sigue desde su recuadro en %1, fotograma %2: %3 × %4. Este método no necesita color; para otro recuadro pulsa Recuadro y haz clic en la cosa.</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it in any camera view.</source>
        <translation>Haz clic en la cosa o arrastra un recuadro a su alrededor en cualquier cámara.</translation>
    </message>
    <message>
        <source>Remove color</source>
        <translation>Quitar color</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorPicker</name>
    <message>
        <source>H&amp;ue</source>
        <translation>&amp;Tono</translation>
    </message>
    <message>
        <source>&amp;Saturation</source>
        <translation>&amp;Saturación</translation>
    </message>
    <message>
        <source>&amp;Intensity</source>
        <translation>&amp;Intensidad</translation>
    </message>
    <message>
        <source>First hue, 0 to 360 degrees; above the last hue the range goes through red</source>
        <translation>Primer tono, de 0 a 360 grados; por encima del último tono el intervalo pasa por el rojo</translation>
    </message>
    <message>
        <source>Last hue, 0 to 360 degrees</source>
        <translation>Último tono, de 0 a 360 grados</translation>
    </message>
    <message>
        <source>Least saturation, 0 to 1</source>
        <translation>Saturación mínima, de 0 a 1</translation>
    </message>
    <message>
        <source>Greatest saturation, 0 to 1</source>
        <translation>Saturación máxima, de 0 a 1</translation>
    </message>
    <message>
        <source>Least intensity, 0 to 1</source>
        <translation>Intensidad mínima, de 0 a 1</translation>
    </message>
    <message>
        <source>Greatest intensity, 0 to 1</source>
        <translation>Intensidad máxima, de 0 a 1</translation>
    </message>
    <message>
        <source>Drag the ends or the middle; with the keyboard, Tab chooses and the arrows move (with Shift ten times as far)</source>
        <translation>Arrastre los extremos o el centro; con el teclado, Tab elige y las flechas mueven (con Mayús diez veces más)</translation>
    </message>
    <message>
        <source>Range of hues</source>
        <translation>Intervalo de tonos</translation>
    </message>
    <message>
        <source>Range of saturation</source>
        <translation>Intervalo de saturación</translation>
    </message>
    <message>
        <source>Range of intensity</source>
        <translation>Intervalo de intensidad</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ColorSampleList</name>
    <message>
        <source>Learned from</source>
        <translation>Aprendido de</translation>
    </message>
    <message>
        <source>Samples the color was learned from</source>
        <translation>Muestras de las que se aprendió el color</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>not this: %1, frame %2, at %3, %4</source>
        <translation>esto no: %1, fotograma %2, en %3, %4</translation>
    </message>
    <message>
        <source>%1, frame %2, at %3, %4</source>
        <translation>%1, fotograma %2, en %3, %4</translation>
    </message>
    <message>
        <source>found: %1, frame %2, at %3, %4</source>
        <translation>encontrada: %1, fotograma %2, en %3, %4</translation>
    </message>
    <message>
        <source>Shift-click in an image adds one, Alt-click or Ctrl+Shift-click excludes one. Samples marked “found” were not clicked, but found in other cameras.</source>
        <translation>Mayús+clic en una imagen añade una; Alt+clic o Ctrl+Mayús+clic excluye una. Las muestras marcadas como «encontrada» no se marcaron con un clic, sino que se encontraron en otras cámaras.</translation>
    </message>
    <message>
        <source>Forget the chosen sample and learn from the rest (Del). A found sample becomes an excluded one.</source>
        <translation>Olvidar la muestra elegida y aprender de las demás (Supr). Una muestra encontrada pasa a estar excluida.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CommandPalette</name>
    <message>
        <source>What do you want to do?</source>
        <translation>¿Qué quiere hacer?</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Buscar acciones</translation>
    </message>
    <message>
        <source>Actions found</source>
        <translation>Acciones encontradas</translation>
    </message>
    <message>
        <source>Nothing here is called “%1”.</source>
        <translation>Aquí no hay nada llamado «%1».</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionMode</name>
    <message>
        <source>Drag the target in an image to where it is; the same in another image fixes its depth. Esc ends it.</source>
        <translation>Arrastre el objetivo en una imagen adonde está; lo mismo en otra imagen fija su profundidad. Esc termina.</translation>
    </message>
    <message>
        <source>Correct position</source>
        <translation>Corregir la posición</translation>
    </message>
    <message>
        <source>There is no correction in this frame.</source>
        <translation>No hay ninguna corrección en este fotograma.</translation>
    </message>
    <message>
        <source>Remove correction</source>
        <translation>Quitar la corrección</translation>
    </message>
    <message>
        <source>Say that the target is here in the frame shown: tracking goes on from there</source>
        <translation>Decir que el objetivo está aquí en el fotograma mostrado: el seguimiento continúa desde ahí</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CorrectionTool</name>
    <message>
        <source>Drag the target to where it is</source>
        <translation>Arrastre el objetivo adonde está</translation>
    </message>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter says that the target is there</source>
        <translation>Imagen de %1: las flechas mueven una cruz, Intro dice que el objetivo está ahí</translation>
    </message>
    <message>
        <source>Frames are being tracked again: wait until that is done, or pause.</source>
        <translation>Se están siguiendo fotogramas otra vez: espere a que termine, o haga una pausa.</translation>
    </message>
    <message>
        <source>There is no target yet: learn its color first.</source>
        <translation>Aún no hay ningún objetivo: aprenda primero su color.</translation>
    </message>
    <message>
        <source>Drag an estimate, or select the target in the list first.</source>
        <translation>Arrastre una estimación, o elija primero el objetivo en la lista.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::CoverageMap</name>
    <message>
        <source>%1: seen %2 times, in %3 of %4 regions of the image</source>
        <translation>%1: vista %2 veces, en %3 de %4 zonas de la imagen</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DockTitle</name>
    <message>
        <source>Float this view, or put it back (double click the title: whole window)</source>
        <translation>Soltar esta vista o devolverla a su sitio (doble clic en el título: toda la ventana)</translation>
    </message>
    <message>
        <source>Show all views</source>
        <translation>Mostrar todas las vistas</translation>
    </message>
    <message>
        <source>Give the other views their places back (Esc, or double click here)</source>
        <translation>Devolver las demás vistas a su sitio (Esc, o doble clic aquí)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Document</name>
    <message>
        <source>Change “%1”</source>
        <translation>Cambiar «%1»</translation>
    </message>
    <message>
        <source>Track by “%1”</source>
        <translation>Seguir con «%1»</translation>
    </message>
    <message>
        <source>Reset “%1”</source>
        <translation>Restablecer «%1»</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Restablecer todos los parámetros</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::DropZone</name>
    <message>
        <source>Drop videos here, or add them</source>
        <translation>Suelte vídeos aquí o añádalos</translation>
    </message>
    <message>
        <source>One per camera; also folders of images, and a calibration file</source>
        <translation>Uno por cámara; también carpetas de imágenes y un archivo de calibración</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExchangeDialog</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>The file, or the folder with a file for each camera</source>
        <translation>El archivo, o la carpeta con un archivo por cámara</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Elegir el archivo</translation>
    </message>
    <message>
        <source>Find the file</source>
        <translation>Buscar el archivo</translation>
    </message>
    <message>
        <source>What is decided</source>
        <translation>Qué se decide</translation>
    </message>
    <message>
        <source>Choose a file. What is decided about it is shown here before anything changes.</source>
        <translation>Elija un archivo. Lo que se decide sobre él se muestra aquí antes de cambiar nada.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>No cambiar nada</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExperimentDialog</name>
    <message>
        <source>Canceled.</source>
        <translation>Cancelado.</translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation>Experimentos</translation>
    </message>
    <message>
        <source>Number of seeds. More seeds take longer and give more certain results.</source>
        <translation>Cuántas semillas: más tardan más y son más seguras</translation>
    </message>
    <message>
        <source>The report, its pictures and its numbers go there</source>
        <translation>Ahí van el informe, sus imágenes y sus números</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the folder of the report</source>
        <translation>Elegir la carpeta del informe</translation>
    </message>
    <message>
        <source>How far the experiment is</source>
        <translation>Progreso del experimento</translation>
    </message>
    <message>
        <source>Run the chosen experiment (Enter)</source>
        <translation>Ejecutar el experimento elegido (Intro)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop the experiment; nothing is written</source>
        <translation>Detener el experimento; no se escribe nada</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Abrir el informe</translation>
    </message>
    <message>
        <source>Show the last report in the web browser</source>
        <translation>Mostrar el último informe en el navegador</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation>Carpeta del informe</translation>
    </message>
    <message>
        <source>Name the folder of the report first.</source>
        <translation>Indica primero la carpeta del informe.</translation>
    </message>
    <message>
        <source>Running “%1”…</source>
        <translation>Ejecutando «%1»…</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>El informe está en %1.</translation>
    </message>
    <message>
        <source>Runs per case</source>
        <translation>Ejecuciones por caso</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Run it</source>
        <translation>Ejecutar</translation>
    </message>
    <message>
        <source>Folder of the recordings</source>
        <translation>Carpeta de las grabaciones</translation>
    </message>
    <message>
        <source>Clothes</source>
        <translation>Ropa</translation>
    </message>
    <message>
        <source>Whether the clothes of the simulated people tell them apart</source>
        <translation>Si la ropa de las personas simuladas las distingue</translation>
    </message>
    <message>
        <source>both kinds</source>
        <translation>ambas clases</translation>
    </message>
    <message>
        <source>different</source>
        <translation>distinta</translation>
    </message>
    <message>
        <source>similar</source>
        <translation>parecida</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Grabaciones</translation>
    </message>
    <message>
        <source>none: a rendered clip only</source>
        <translation>ninguna: solo un vídeo generado</translation>
    </message>
    <message>
        <source>Folder with the recordings juggle1 and otb; without one, a rendered clip only</source>
        <translation>Carpeta con las grabaciones juggle1 y otb; sin ella, solo un vídeo generado</translation>
    </message>
    <message>
        <source>Choose the folder of the recordings</source>
        <translation>Elegir la carpeta de las grabaciones</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportDialog</name>
    <message>
        <source>Export trajectory</source>
        <translation>Exportar la trayectoria</translation>
    </message>
    <message>
        <source>Write a figure</source>
        <translation>Escribir una figura</translation>
    </message>
    <message>
        <source>Figures (*.svg *.pdf)</source>
        <translation>Figuras (*.svg *.pdf)</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>tiempo (s)</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>desde arriba</translation>
    </message>
    <message>
        <source>The export was canceled.</source>
        <translation>La exportación se canceló.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>File to write</source>
        <translation>Archivo que se escribe</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>Examinar…</translation>
    </message>
    <message>
        <source>Choose the file to write</source>
        <translation>Elegir el archivo que se escribe</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop the work under way; what is there already stays as it was</source>
        <translation>Detener lo que está en marcha; lo que ya hay queda como estaba</translation>
    </message>
    <message>
        <source>Figure…</source>
        <translation>Figura…</translation>
    </message>
    <message>
        <source>Write a figure of it as SVG or PDF: x, y, z over time and from above</source>
        <translation>Escribir una figura como SVG o PDF: x, y, z en el tiempo y desde arriba</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Write the file in the background</source>
        <translation>Escribir el archivo en segundo plano</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close; an export that is under way goes on</source>
        <translation>Cerrar; una exportación en curso continúa</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>%1 exists already; nothing was written.</source>
        <translation>%1 ya existe; no se escribió nada.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Which program is to read it</source>
        <translation>Qué programa lo leerá</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Those with a mark are exported; all, if none has one</source>
        <translation>Se exportan los marcados; todos, si no hay ninguno marcado</translation>
    </message>
    <message>
        <source>Estimates</source>
        <translation>Estimaciones</translation>
    </message>
    <message>
        <source>As they were known live, or as all frames before and after tell</source>
        <translation>Como se conocían en vivo, o como las muestran todos los fotogramas anteriores y posteriores</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>First time, 0 to 1,000,000 s</source>
        <translation>Primer instante, de 0 a 1.000.000 s</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Last time, 0 to 1,000,000 s</source>
        <translation>Último instante, de 0 a 1.000.000 s</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frecuencia</translation>
    </message>
    <message>
        <source>Rows per second, 0.001 to 10,000; interpolated</source>
        <translation>Filas por segundo, de 0,001 a 10.000; interpoladas</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Huecos</translation>
    </message>
    <message>
        <source>What to write where the target is not known</source>
        <translation>Qué escribir donde no se conoce el objetivo</translation>
    </message>
    <message>
        <source>Longest gap</source>
        <translation>Hueco más largo</translation>
    </message>
    <message>
        <source>A longer gap is left, 0.01 to 60 s</source>
        <translation>Un hueco más largo se deja, de 0,01 a 60 s</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>Ejes del mundo</translation>
    </message>
    <message>
        <source>Which axis points up in the file</source>
        <translation>Qué eje apunta hacia arriba en el archivo</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Longitudes</translation>
    </message>
    <message>
        <source>Unit of positions in the file</source>
        <translation>Unidad de las posiciones en el archivo</translation>
    </message>
    <message>
        <source>the beginning</source>
        <translation>el principio</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>el final</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>como se grabó</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> per second</source>
        <translation> por segundo</translation>
    </message>
    <message>
        <source>Notes about the run</source>
        <translation>Notas sobre la ejecución</translation>
    </message>
    <message>
        <source>Method, seed, parameters, units and axes as comments in the file</source>
        <translation>Método, semilla, parámetros, unidades y ejes como comentarios en el archivo</translation>
    </message>
    <message>
        <source>live</source>
        <translation>en vivo</translation>
    </message>
    <message>
        <source>smoothed after the run</source>
        <translation>suavizadas tras la ejecución</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>dejar</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>rellenar</translation>
    </message>
    <message>
        <source>as usual in the format</source>
        <translation>lo habitual en el formato</translation>
    </message>
    <message>
        <source>Z up</source>
        <translation>Z hacia arriba</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y hacia arriba</translation>
    </message>
    <message>
        <source>meters</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>millimeters</source>
        <translation>milímetros</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ExportOutcome</name>
    <message>
        <source>Show in folder</source>
        <translation>Mostrar en la carpeta</translation>
    </message>
    <message>
        <source>Open the folder of the file that was written</source>
        <translation>Abrir la carpeta del archivo escrito</translation>
    </message>
    <message>
        <source>No file manager was found. The file is %1.</source>
        <translation>No se encontró ningún gestor de archivos. El archivo es %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::FollowAllButton</name>
    <message numerus="yes">
        <source>Follow all %n of them</source>
        <translation>
            <numerusform>Seguir %n</numerusform>
            <numerusform>Seguir las %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Add a target of the same color and size for each of the others</source>
        <translation>Añadir un objetivo del mismo color y tamaño por cada una de las demás</translation>
    </message>
    <message>
        <source>Follow all of one color</source>
        <translation>Seguir todo lo de un color</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GalleryCard</name>
    <message>
        <source>Opening…</source>
        <translation>Abriendo…</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GapList</name>
    <message>
        <source>Gaps of the trajectory</source>
        <translation>Huecos de la trayectoria</translation>
    </message>
    <message>
        <source>gap from</source>
        <translation>hueco desde</translation>
    </message>
    <message>
        <source>to</source>
        <translation>hasta</translation>
    </message>
    <message>
        <source>length</source>
        <translation>duración</translation>
    </message>
    <message>
        <source>target</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>fotograma %1</translation>
    </message>
    <message numerus="yes">
        <source>%n frames</source>
        <translation>
            <numerusform>%n fotograma</numerusform>
            <numerusform>%n fotogramas</numerusform>
        </translation>
    </message>
    <message>
        <source>Seconds from the last held estimate before the gap to the first one after it</source>
        <translation>Segundos desde la última estimación segura antes del hueco hasta la primera después</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridForm</name>
    <message>
        <source>Change the reference grid</source>
        <translation>Cambiar la cuadrícula de referencia</translation>
    </message>
    <message>
        <source>Grid on</source>
        <translation>Cuadrícula en</translation>
    </message>
    <message>
        <source>the floor</source>
        <translation>el suelo</translation>
    </message>
    <message>
        <source>a wall</source>
        <translation>una pared</translation>
    </message>
    <message>
        <source>a box</source>
        <translation>una caja</translation>
    </message>
    <message>
        <source>Kind of grid</source>
        <translation>Tipo de cuadrícula</translation>
    </message>
    <message>
        <source>What the grid lies on in the room</source>
        <translation>Sobre qué está la cuadrícula en la sala</translation>
    </message>
    <message>
        <source>Size along x, y, z</source>
        <translation>Tamaño según x, y, z</translation>
    </message>
    <message>
        <source>Begins at x, y, z</source>
        <translation>Empieza en x, y, z</translation>
    </message>
    <message>
        <source>Size along %1</source>
        <translation>Tamaño según %1</translation>
    </message>
    <message>
        <source>How far the grid reaches, in meters</source>
        <translation>Hasta dónde llega la cuadrícula, en metros</translation>
    </message>
    <message>
        <source>Origin %1</source>
        <translation>Origen %1</translation>
    </message>
    <message>
        <source>The corner where its axes begin, in meters</source>
        <translation>La esquina donde empiezan sus ejes, en metros</translation>
    </message>
    <message>
        <source>Step, turn</source>
        <translation>Paso, giro</translation>
    </message>
    <message>
        <source>Step of the grid</source>
        <translation>Paso de la cuadrícula</translation>
    </message>
    <message>
        <source>Meters from line to line</source>
        <translation>Metros de línea a línea</translation>
    </message>
    <message>
        <source>Turn of the grid</source>
        <translation>Giro de la cuadrícula</translation>
    </message>
    <message>
        <source>Turned about the vertical, counterclockwise from above</source>
        <translation>Girada alrededor de la vertical, en sentido antihorario desde arriba</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacidad</translation>
    </message>
    <message>
        <source>Opacity of the grid</source>
        <translation>Opacidad de la cuadrícula</translation>
    </message>
    <message>
        <source>How strongly the grid is drawn over the images</source>
        <translation>Con qué fuerza se dibuja la cuadrícula sobre las imágenes</translation>
    </message>
    <message>
        <source>Show edges of the images</source>
        <translation>Mostrar los bordes de las imágenes</translation>
    </message>
    <message>
        <source>Let the rest of the images step back behind their edges</source>
        <translation>El resto de las imágenes se atenúa tras sus bordes</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Show the cameras as they were before</source>
        <translation>Mostrar las cámaras como estaban antes</translation>
    </message>
    <message>
        <source>While held down (or B, over an image): the grid as it was when the calibration was opened</source>
        <translation>Mientras se mantiene pulsado (o B, sobre una imagen): la cuadrícula como estaba al abrir la calibración</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::GridLayer</name>
    <message>
        <source>Grid over the image of %1</source>
        <translation>Cuadrícula sobre la imagen de %1</translation>
    </message>
    <message>
        <source>Drag the grid onto the real thing; click to hold a point; arrows, W A S D, Q and E move or turn the camera</source>
        <translation>Arrastre la cuadrícula sobre lo real; un clic sujeta un punto; flechas, W A S D, Q y E mueven o giran la cámara</translation>
    </message>
    <message>
        <source>before</source>
        <translation>antes</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistogramView</name>
    <message>
        <source>Colors of the box</source>
        <translation>Colores del recuadro</translation>
    </message>
    <message>
        <source>Color histograms of the bounding box: outlined bars for the reference, filled bars for the current frame. The largest of the 512 bins are shown, each in its own color.</source>
        <translation>Histogramas de color del recuadro: barras huecas, como se indicó; barras llenas, como es ahora. Se muestran las mayores de 512 clases, cada una en su color.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::HistoryDock</name>
    <message>
        <source>As it was opened</source>
        <translation>Como se abrió</translation>
    </message>
    <message>
        <source>History of changes</source>
        <translation>Historial de cambios</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Deshacer: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Rehacer: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ImagePickTool</name>
    <message>
        <source>Image of %1: arrow keys move a cross, Enter points there</source>
        <translation>Imagen de %1: las flechas mueven una cruz, Intro señala ahí</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LearnModes</name>
    <message>
        <source>What a click in an image does</source>
        <translation>Qué hace un clic en una imagen</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Recuadro</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Aprender</translation>
    </message>
    <message>
        <source>Add sample</source>
        <translation>Añadir muestra</translation>
    </message>
    <message>
        <source>Not this</source>
        <translation>Esto no</translation>
    </message>
    <message>
        <source>Learn the color first: click the target in a camera image.</source>
        <translation>Aprenda primero el color: haga clic en el objetivo en una imagen de cámara.</translation>
    </message>
    <message>
        <source>Click: add a sample · Alt: not this · Esc</source>
        <translation>Clic: añadir una muestra · Alt: esto no · Esc</translation>
    </message>
    <message>
        <source>Click what is not the target · Esc</source>
        <translation>Haga clic en lo que no es el objetivo · Esc</translation>
    </message>
    <message>
        <source>Click: learn · Shift: add · Alt: not this · Esc</source>
        <translation>Clic: aprender · Mayús: añadir · Alt: esto no · Esc</translation>
    </message>
    <message>
        <source>Click the object in a camera image, or drag a box around it.
Shift-click works at any time.</source>
        <translation>Haga clic en el objeto en una imagen, o dibuje un recuadro a su alrededor.
Mayús-clic funciona en cualquier momento.</translation>
    </message>
    <message>
        <source>Click the target in a camera image, or drag a box on it,
to learn its color again.</source>
        <translation>Haga clic en el objetivo en una imagen, o dibuje un recuadro sobre él,
para aprender su color de nuevo.</translation>
    </message>
    <message>
        <source>Click another part of the target, or the target in different light.
Shift-click works at any time.</source>
        <translation>Haga clic en otra parte del objetivo, o en el objetivo con otra luz.
Mayús-clic funciona en cualquier momento.</translation>
    </message>
    <message>
        <source>Click something that matches but is not the target.
Alt-click or Ctrl+Shift-click works at any time.</source>
        <translation>Haga clic en algo que coincide pero no es el objetivo.
Alt-clic o Ctrl+Mayús-clic funciona en cualquier momento.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::LegendPicture</name>
    <message>
        <source>Cross: the estimate, the weighted mean of the particles.</source>
        <translation>Cruz: la estimación, la media ponderada de las partículas.</translation>
    </message>
    <message>
        <source>Unbroken ellipse: with 95 % probability the target is inside. The smaller, the surer.</source>
        <translation>Elipse continua: con una probabilidad del 95 % el objetivo está dentro. Cuanto más pequeña, más segura.</translation>
    </message>
    <message>
        <source>Dashed ellipse: the size of the target itself, where it is not a ball.</source>
        <translation>Elipse discontinua: el tamaño del propio objetivo, cuando no es una bola.</translation>
    </message>
    <message>
        <source>White diamond: where the target really is. Only simulated scenes, such as the demo, know it.</source>
        <translation>Rombo blanco: dónde está realmente el objetivo. Solo lo saben las escenas simuladas, como la demostración.</translation>
    </message>
    <message>
        <source>Triangle: the particle of highest weight (View › Show best particle).</source>
        <translation>Triángulo: la partícula de mayor peso (Ver › Mostrar la mejor partícula).</translation>
    </message>
    <message>
        <source>Line through the image: the ray of another camera along which the target must be, while you drag it to where it is.</source>
        <translation>Línea a través de la imagen: el rayo de otra cámara sobre el que debe estar el objetivo, mientras lo arrastra adonde está.</translation>
    </message>
    <message>
        <source>Dots: particles. Each is one guess of where the target is; the brighter, the better it fits the images.</source>
        <translation>Puntos: partículas. Cada una es una suposición de dónde está el objetivo; cuanto más clara, mejor encaja con las imágenes.</translation>
    </message>
    <message>
        <source>Tinted and outlined: where the image has the color of the target (View › Show mask).</source>
        <translation>Teñido y contorneado: donde la imagen tiene el color del objetivo (Ver › Mostrar máscara).</translation>
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
        <source>Three points are held already: click one of them to let go of it</source>
        <translation>Ya hay tres puntos sujetos: haga clic en uno para soltarlo</translation>
    </message>
    <message>
        <source>Drag the grid in %1</source>
        <translation>Arrastrar la cuadrícula en %1</translation>
    </message>
    <message>
        <source>No further: a point would leave what the camera can see</source>
        <translation>No más allá: un punto saldría de lo que la cámara puede ver</translation>
    </message>
    <message>
        <source>No further: the held points and this one lie on one ray or line</source>
        <translation>No más allá: los puntos sujetos y este están en un mismo rayo o recta</translation>
    </message>
    <message>
        <source>No further: no pose near this one shows the held points where they are</source>
        <translation>No más allá: ninguna pose cercana muestra los puntos sujetos donde están</translation>
    </message>
    <message>
        <source>Three held points fix the pose: let go of one, or let the focal length change</source>
        <translation>Tres puntos sujetos fijan la pose: suelte uno, o deje que cambie la distancia focal</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>adelante</translation>
    </message>
    <message>
        <source>up</source>
        <translation>arriba</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>cabeceo</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>alabeo</translation>
    </message>
    <message>
        <source>yaw</source>
        <translation>guiñada</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>%1 focal length %2 %</source>
        <translation>%1 distancia focal %2 %</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualCalibrationPage</name>
    <message>
        <source>Drag the grid in an image until it lies on the real thing. Click a point of it to hold it there.</source>
        <translation>Arrastre la cuadrícula en una imagen hasta que coincida con lo real. Un clic en uno de sus puntos lo sujeta ahí.</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Reference grid</source>
        <translation>Cuadrícula de referencia</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Puntos medidos</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>A mano</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ManualWindow</name>
    <message>
        <source>Manual – Dewpoint</source>
        <translation>Manual – Dewpoint</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Páginas del manual</translation>
    </message>
    <message>
        <source>Back to the page before</source>
        <translation>Volver a la página anterior</translation>
    </message>
    <message>
        <source>Forward again</source>
        <translation>Avanzar de nuevo</translation>
    </message>
    <message>
        <source>The manual was not found. It is expected in the folder %1.</source>
        <translation>No se encontró el manual. Debería estar en la carpeta %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MarkerEditor</name>
    <message>
        <source>Name of the mark</source>
        <translation>Nombre de la marca</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <translation>Marca %1</translation>
    </message>
    <message>
        <source>Add a mark</source>
        <translation>Añadir una marca</translation>
    </message>
    <message>
        <source>Remove a mark</source>
        <translation>Quitar una marca</translation>
    </message>
    <message>
        <source>Rename a mark</source>
        <translation>Renombrar una marca</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Cerrar este mensaje</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MessageRow</name>
    <message>
        <source>Messages</source>
        <translation>Mensajes</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::MissingFilesOffer</name>
    <message>
        <source>%1 was not found in %2.</source>
        <translation>No se encontró %1 en %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n files of this project were not found: %1.</source>
        <translation>
            <numerusform>No se encontró %n archivo de este proyecto: %1.</numerusform>
            <numerusform>No se encontraron %n archivos de este proyecto: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>Buscar…</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>Buscar %1</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Opened with the located files. Save the project to keep where they are.</source>
        <translation>Abierto con los archivos localizados. Guarde el proyecto para conservar dónde están.</translation>
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
        <translation>Proyecto nuevo</translation>
    </message>
    <message>
        <source>Video files, one per camera</source>
        <translation>Archivos de vídeo, uno por cámara</translation>
    </message>
    <message>
        <source>A folder of images, one per frame</source>
        <translation>Una carpeta de imágenes, una por fotograma</translation>
    </message>
    <message>
        <source>All cameras connected to this computer</source>
        <translation>Todas las cámaras conectadas a este equipo</translation>
    </message>
    <message>
        <source>A device number or a network stream; type it in</source>
        <translation>Un número de dispositivo o un flujo de red; escríbalo</translation>
    </message>
    <message>
        <source>Take the chosen cameras out</source>
        <translation>Quitar las cámaras elegidas</translation>
    </message>
    <message>
        <source>Make the project and show its first images</source>
        <translation>Crear el proyecto y mostrar sus primeras imágenes</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Back without making a project</source>
        <translation>Volver sin crear un proyecto</translation>
    </message>
    <message>
        <source>Name of the project</source>
        <translation>Nombre del proyecto</translation>
    </message>
    <message>
        <source>Rate of image folders, 0.1 to 10,000 per second</source>
        <translation>Frecuencia de las carpetas de imágenes, de 0,1 a 10 000 por segundo</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>Images from</source>
        <translation>Imágenes de</translation>
    </message>
    <message>
        <source>Cameras of the new project</source>
        <translation>Cámaras del proyecto nuevo</translation>
    </message>
    <message>
        <source>Choose one video per camera</source>
        <translation>Elija un vídeo por cámara</translation>
    </message>
    <message>
        <source>Videos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;All files (*)</source>
        <translation>Vídeos (*.mp4 *.mkv *.avi *.mov *.m4v *.mpg *.mpeg *.webm *.mjpeg);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Choose a folder of images</source>
        <translation>Elija una carpeta de imágenes</translation>
    </message>
    <message>
        <source>No camera is connected to this computer. A network camera can be added by its address.</source>
        <translation>No hay ninguna cámara conectada a este equipo. Una cámara de red se puede añadir por su dirección.</translation>
    </message>
    <message>
        <source>Without a calibration the camera positions are a guess: images can be tracked, but positions in space mean nothing yet.</source>
        <translation>Sin calibración las posiciones de las cámaras son una suposición: se puede seguir en las imágenes, pero las posiciones en el espacio aún no significan nada.</translation>
    </message>
    <message>
        <source>The calibration names its cameras differently: they were taken in its order.</source>
        <translation>La calibración llama a sus cámaras de otro modo: se tomaron en su orden.</translation>
    </message>
    <message>
        <source>Add videos…</source>
        <translation>Añadir vídeos…</translation>
    </message>
    <message>
        <source>Add image folder…</source>
        <translation>Añadir carpeta de imágenes…</translation>
    </message>
    <message>
        <source>Add connected cameras</source>
        <translation>Añadir cámaras conectadas</translation>
    </message>
    <message>
        <source>Add address</source>
        <translation>Añadir dirección</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Crear</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
    <message>
        <source>Images per second:</source>
        <translation>Imágenes por segundo:</translation>
    </message>
    <message>
        <source>Neither a video, nor images, nor a calibration: %1.</source>
        <translation>Ni un vídeo, ni imágenes, ni una calibración: %1.</translation>
    </message>
    <message>
        <source>One row per camera. Videos must be synchronized: frame N shows the same moment in all of them.</source>
        <translation>Una fila por cámara. Los vídeos deben estar sincronizados: el fotograma N muestra el mismo momento en todos.</translation>
    </message>
    <message>
        <source>(folder name)</source>
        <translation>(nombre de la carpeta)</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Encontrado</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OldResultsOffer</name>
    <message>
        <source>Settings changed since this run.</source>
        <translation>Los ajustes cambiaron después de esta ejecución.</translation>
    </message>
    <message>
        <source>Track again</source>
        <translation>Seguir de nuevo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::OverlayLegend</name>
    <message>
        <source>Legend of the overlays</source>
        <translation>Leyenda de los signos</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ParameterPanel</name>
    <message>
        <source>The parameters appear here once a project is open.</source>
        <translation>Los parámetros aparecen aquí en cuanto se abre un proyecto.</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>&amp;Método</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it in any camera view.</source>
        <translation>Haz clic en la cosa o arrastra un recuadro a su alrededor en cualquier cámara.</translation>
    </message>
    <message>
        <source>This method works in the room: calibrate the cameras first (menu Calibration), their positions are only a guess.</source>
        <translation>Este método trabaja en el espacio: calibra primero las cámaras (menú Calibración), sus posiciones son solo una suposición.</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>More than “%1”: %2 is used.</source>
        <translation>Mayor que «%1»: se usa %2.</translation>
    </message>
    <message>
        <source>Less than “%1”, which has no effect then.</source>
        <translation>Menor que «%1», que entonces no tiene efecto.</translation>
    </message>
    <message>
        <source>How the targets are tracked. Another method starts again; the rest stays.</source>
        <translation>Cómo se siguen los objetivos. Otro método empieza de nuevo; el resto se queda.</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restablecer todo</translation>
    </message>
    <message>
        <source>Give all parameters of this method their defaults</source>
        <translation>Devolver todos los parámetros de este método a sus valores por defecto</translation>
    </message>
    <message>
        <source>Volume of interest</source>
        <translation>Volumen de interés</translation>
    </message>
    <message>
        <source>Targets are searched for in a box alone.</source>
        <translation>Los objetivos se buscan solo en una caja.</translation>
    </message>
    <message>
        <source>Something here differs from its default.</source>
        <translation>Algo aquí difiere de su valor por defecto.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeopleDock</name>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Click somebody in a camera image, or the floor in the bird&apos;s-eye view. Esc ends it.</source>
        <translation>Haga clic en alguien en una imagen de cámara, o en el suelo en la vista de pájaro. Esc lo termina.</translation>
    </message>
    <message>
        <source>Folder for the tables of people</source>
        <translation>Carpeta para las tablas de personas</translation>
    </message>
    <message>
        <source>There are tables of another run in %1. Replace them?</source>
        <translation>En %1 hay tablas de otra ejecución. ¿Reemplazarlas?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
    <message>
        <source>That run is over; the tables of its people were not written.</source>
        <translation>Esa ejecución terminó; las tablas de sus personas no se escribieron.</translation>
    </message>
    <message>
        <source>Places, volumes, hulls and densities of people are in %1 (frames: %2).</source>
        <translation>Los lugares, volúmenes, envolventes y densidades de las personas están en %1 (fotogramas: %2).</translation>
    </message>
    <message>
        <source>Writing the tables of people…</source>
        <translation>Escribiendo las tablas de personas…</translation>
    </message>
    <message>
        <source>Add a person</source>
        <translation>Añadir una persona</translation>
    </message>
    <message>
        <source>Remove a person</source>
        <translation>Quitar una persona</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PeoplePanel</name>
    <message>
        <source>People who are there</source>
        <translation>Personas presentes</translation>
    </message>
    <message>
        <source>How much of the empty room is learned</source>
        <translation>Cuánto de la sala vacía se ha aprendido</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Number of the person, which nobody else gets in this run</source>
        <translation>Número de la persona, que nadie más recibe en esta ejecución</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Place in the room, x and y in meters</source>
        <translation>Lugar en la sala, x e y en metros</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Estatura</translation>
    </message>
    <message>
        <source>Estimated height, meters; empty: the method does not estimate it</source>
        <translation>Estatura estimada, metros; vacío: el método no la estima</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Meters per second over the floor</source>
        <translation>Metros por segundo sobre el suelo</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Cameras that see the person, of all</source>
        <translation>Cámaras que ven a la persona, del total</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volume of the hull that holds 95 % of the person, cubic meters; empty while hulls are not shown</source>
        <translation>Volumen de la envolvente que contiene el 95 % de la persona, metros cúbicos; vacío mientras no se muestran envolventes</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>How long the person has been there, seconds</source>
        <translation>Cuánto tiempo lleva la persona, segundos</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Cerca</translation>
    </message>
    <message>
        <source>Somebody else is so near that colors are not learned</source>
        <translation>Hay alguien tan cerca que no se aprenden los colores</translation>
    </message>
    <message>
        <source>Learning the empty room: %1 %. Keep out of view.</source>
        <translation>Aprendiendo la sala vacía: %1 %. No entre en la imagen.</translation>
    </message>
    <message>
        <source>Nobody is there. People appear when two cameras see them.</source>
        <translation>No hay nadie. Las personas aparecen cuando las ven dos cámaras.</translation>
    </message>
    <message>
        <source>People there: %1</source>
        <translation>Personas presentes: %1</translation>
    </message>
    <message>
        <source>People appear here once a method for people runs.</source>
        <translation>Las personas aparecen aquí cuando se ejecuta un método para personas.</translation>
    </message>
    <message>
        <source>Somebody is near</source>
        <translation>Hay alguien cerca</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlanPage</name>
    <message>
        <source>How well will these cameras measure, and where would one more help? Drag a camera in the bird&apos;s-eye view: the map follows.</source>
        <translation>¿Qué tal medirán estas cámaras, y dónde ayudaría otra? Arrastre una cámara en la vista de pájaro: el mapa la sigue.</translation>
    </message>
    <message>
        <source>Map of expected errors</source>
        <translation>Mapa de errores esperados</translation>
    </message>
    <message>
        <source>Planned cameras</source>
        <translation>Cámaras planeadas</translation>
    </message>
    <message>
        <source>Planned cameras are neither saved with the project nor part of the run. The map takes nothing in the room into account that hides a place.</source>
        <translation>Las cámaras planeadas no se guardan con el proyecto ni forman parte de la ejecución. El mapa no tiene en cuenta nada de la sala que oculte un lugar.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planificar</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerForm</name>
    <message>
        <source>Add a camera to plan</source>
        <translation>Añadir una cámara al plan</translation>
    </message>
    <message>
        <source>A camera that is not there yet: drag it in the bird&apos;s-eye view, or type where it stands (%1)</source>
        <translation>Una cámara que aún no existe: arrástrela en la vista de pájaro o escriba dónde está (%1)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the planned camera</source>
        <translation>Quitar la cámara planeada</translation>
    </message>
    <message>
        <source>Take the chosen planned camera away</source>
        <translation>Quitar la cámara planeada elegida</translation>
    </message>
    <message>
        <source>Planned camera</source>
        <translation>Cámara planeada</translation>
    </message>
    <message>
        <source>The planned camera that the numbers below belong to</source>
        <translation>La cámara planeada a la que pertenecen los números de abajo</translation>
    </message>
    <message>
        <source>Stands at x, y, z</source>
        <translation>Está en x, y, z</translation>
    </message>
    <message>
        <source>Looks at x, y, z</source>
        <translation>Mira a x, y, z</translation>
    </message>
    <message>
        <source>Field of view, image width and height</source>
        <translation>Campo de visión, anchura y altura de la imagen</translation>
    </message>
    <message>
        <source>Planned position %1</source>
        <translation>Posición planeada %1</translation>
    </message>
    <message>
        <source>Where the camera stands, in meters</source>
        <translation>Dónde está la cámara, en metros</translation>
    </message>
    <message>
        <source>Planned camera looks at %1</source>
        <translation>La cámara planeada mira a %1</translation>
    </message>
    <message>
        <source>A point on its line of sight, in meters</source>
        <translation>Un punto de su línea de visión, en metros</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Campo de visión</translation>
    </message>
    <message>
        <source>How wide the camera sees, from left to right</source>
        <translation>Cuánto abarca la cámara de izquierda a derecha</translation>
    </message>
    <message>
        <source>Image width</source>
        <translation>Anchura de la imagen</translation>
    </message>
    <message>
        <source>Pixels of its image, from left to right</source>
        <translation>Píxeles de su imagen, de izquierda a derecha</translation>
    </message>
    <message>
        <source>Image height</source>
        <translation>Altura de la imagen</translation>
    </message>
    <message>
        <source>Pixels of its image, from top to bottom</source>
        <translation>Píxeles de su imagen, de arriba abajo</translation>
    </message>
    <message>
        <source>Walls and ceiling outside the volume by</source>
        <translation>Paredes y techo fuera del volumen a</translation>
    </message>
    <message>
        <source>Distance of the walls</source>
        <translation>Distancia de las paredes</translation>
    </message>
    <message>
        <source>The search looks on the four walls and the ceiling around the volume, this far outside of it</source>
        <translation>La búsqueda recorre las cuatro paredes y el techo alrededor del volumen, a esta distancia de él</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cancel the search</source>
        <translation>Cancelar la búsqueda</translation>
    </message>
    <message>
        <source>End the search; nothing is added</source>
        <translation>Terminar la búsqueda; no se añade nada</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>aún ninguna</translation>
    </message>
    <message>
        <source>none chosen</source>
        <translation>ninguna elegida</translation>
    </message>
    <message>
        <source>Find the best place for %1</source>
        <translation>Buscar el mejor lugar para %1</translation>
    </message>
    <message>
        <source>Search the walls and the ceiling for the place from which one more camera helps most (%1)</source>
        <translation>Buscar en paredes y techo el lugar desde el que más ayuda otra cámara (%1)</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlannerInstaller</name>
    <message>
        <source>Move %1 in the bird&apos;s-eye view</source>
        <translation>Mover %1 en la vista aérea</translation>
    </message>
    <message>
        <source>Turn %1 in the bird&apos;s-eye view</source>
        <translation>Girar %1 en la vista aérea</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotPanel</name>
    <message>
        <source>Plots of the run</source>
        <translation>Gráficos de la ejecución</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficos</translation>
    </message>
    <message>
        <source>Choose the plots shown; copy or save them</source>
        <translation>Elegir los gráficos mostrados; copiarlos o guardarlos</translation>
    </message>
    <message>
        <source>Choose the plots shown</source>
        <translation>Elegir los gráficos mostrados</translation>
    </message>
    <message>
        <source>The plots are on the clipboard as CSV.</source>
        <translation>Los gráficos están en el portapapeles como CSV.</translation>
    </message>
    <message>
        <source>Save the plots</source>
        <translation>Guardar los gráficos</translation>
    </message>
    <message>
        <source>Drawings (*.svg);;Pictures (*.png)</source>
        <translation>Dibujos (*.svg);;Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se guardó %1.</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>No se pudo escribir %1.</translation>
    </message>
    <message>
        <source>Plots appear when tracking runs.</source>
        <translation>Los gráficos aparecen durante el seguimiento.</translation>
    </message>
    <message>
        <source>The target whose numbers are plotted: the one selected in Target, or the first.</source>
        <translation>El objetivo cuyos números se representan: el elegido en Objetivo, o el primero.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PlotStack</name>
    <message>
        <source>frame %1, iteration %2, %3</source>
        <translation>fotograma %1, iteración %2, %3</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointCalibrator</name>
    <message>
        <source>%1 is rotated and mirrored: turn its images clockwise by %2 degrees, then mirror them</source>
        <translation>%1 está girada y reflejada: gire sus imágenes %2 grados en sentido horario y refléjelas</translation>
    </message>
    <message>
        <source>%1 is mirrored</source>
        <translation>%1 está reflejada</translation>
    </message>
    <message>
        <source>%1 is rotated: turn its images clockwise by %2 degrees</source>
        <translation>%1 está girada: gire sus imágenes %2 grados en sentido horario</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>punto %1</translation>
    </message>
    <message>
        <source>Add measured point</source>
        <translation>Añadir punto medido</translation>
    </message>
    <message>
        <source>Remove measured point</source>
        <translation>Quitar punto medido</translation>
    </message>
    <message>
        <source>Rename measured point</source>
        <translation>Renombrar punto medido</translation>
    </message>
    <message>
        <source>Place of %1</source>
        <translation>Lugar de %1</translation>
    </message>
    <message>
        <source>Click %1 in %2</source>
        <translation>Marcar %1 en %2</translation>
    </message>
    <message>
        <source>Forget %1 in %2</source>
        <translation>Olvidar %1 en %2</translation>
    </message>
    <message>
        <source>Solve cameras from measured points</source>
        <translation>Resolver las cámaras con los puntos medidos</translation>
    </message>
    <message>
        <source>No point was clicked yet: choose one, then click it in the images</source>
        <translation>Aún no se ha marcado ningún punto: elija uno y márquelo en las imágenes</translation>
    </message>
    <message>
        <source>%1: %2 off on average</source>
        <translation>%1: %2 de error medio</translation>
    </message>
    <message>
        <source>%1: %2 points are too few, click four or more</source>
        <translation>%1: %2 puntos son pocos, marque cuatro o más</translation>
    </message>
    <message>
        <source>%1: its points lie on one line, add one beside it</source>
        <translation>%1: sus puntos están en una recta, añada uno fuera de ella</translation>
    </message>
    <message>
        <source>%1: %2, but a second pose fits as well: add a point outside the plane</source>
        <translation>%1: %2, pero otra pose encaja igual: añada un punto fuera del plano</translation>
    </message>
    <message>
        <source>%1: no pose shows the points there</source>
        <translation>%1: ninguna pose muestra ahí los puntos</translation>
    </message>
    <message>
        <source>%1, unless it was mounted so</source>
        <translation>%1, salvo que esté montada así</translation>
    </message>
    <message>
        <source>%1: then its points fit to %2</source>
        <translation>%1: entonces sus puntos encajan a %2</translation>
    </message>
    <message>
        <source>%1 does not fit the rest (%2, %3): measure or click it again</source>
        <translation>%1 no encaja con el resto (%2, %3): mídalo o márquelo otra vez</translation>
    </message>
    <message>
        <source>Worst: %1 (%2, %3)</source>
        <translation>El peor: %1 (%2, %3)</translation>
    </message>
    <message>
        <source>Set how %1 lies</source>
        <translation>Fijar la orientación de %1</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PointsTable</name>
    <message>
        <source>Measured points</source>
        <translation>Puntos medidos</translation>
    </message>
    <message>
        <source>Places measured with a tape, in meters: double click to type. A marked row fits worst.</source>
        <translation>Lugares medidos con cinta, en metros: doble clic para escribir. La fila marcada es la que peor encaja.</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
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
        <source>seen</source>
        <translation>visto</translation>
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
        <translation>Añadir punto</translation>
    </message>
    <message>
        <source>Add a place of the room that you measured</source>
        <translation>Añadir un lugar de la sala que haya medido</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Quitar punto</translation>
    </message>
    <message>
        <source>Remove the chosen point</source>
        <translation>Quitar el punto elegido</translation>
    </message>
    <message>
        <source>Click in images</source>
        <translation>Marcar en imágenes</translation>
    </message>
    <message>
        <source>Then click the chosen point in every image that shows it: corners are found to a fraction of a pixel (Alt: exactly where you click). Esc ends it.</source>
        <translation>Después marque el punto elegido en cada imagen que lo muestre: las esquinas se encuentran con precisión de fracción de píxel (Alt: justo donde hace clic). Esc termina.</translation>
    </message>
    <message>
        <source>Forget click</source>
        <translation>Olvidar la marca</translation>
    </message>
    <message>
        <source>Forget the click of this point in the chosen camera</source>
        <translation>Olvidar la marca de este punto en la cámara elegida</translation>
    </message>
    <message>
        <source>Solve focal lengths too</source>
        <translation>Resolver también las distancias focales</translation>
    </message>
    <message>
        <source>For cameras with six points or more</source>
        <translation>Para cámaras con seis puntos o más</translation>
    </message>
    <message>
        <source>Solve cameras</source>
        <translation>Resolver las cámaras</translation>
    </message>
    <message>
        <source>Find the poses of all cameras in which points were clicked; four points or more each</source>
        <translation>Hallar las poses de todas las cámaras en las que se marcaron puntos; cuatro o más en cada una</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
    <message>
        <source>Set it: %1</source>
        <translation>Fijarlo: %1</translation>
    </message>
    <message>
        <source>Turn or mirror the images of this camera so, and solve again</source>
        <translation>Girar o reflejar así las imágenes de esta cámara y resolver de nuevo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::PreviewPane</name>
    <message>
        <source>Working on the preview: %1 %</source>
        <translation>Preparando la vista previa: %1 %</translation>
    </message>
    <message>
        <source>First lines of the file</source>
        <translation>Primeras líneas del archivo</translation>
    </message>
    <message>
        <source>Units and axes</source>
        <translation>Unidades y ejes</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Some of these results are of earlier settings.</source>
        <translation>Algunos de estos resultados se obtuvieron con ajustes anteriores.</translation>
    </message>
    <message>
        <source>The preview was stopped. The next change begins it anew.</source>
        <translation>La vista previa se detuvo. El próximo cambio la empieza de nuevo.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProblemReport</name>
    <message>
        <source>Report a problem – Dewpoint</source>
        <translation>Informar de un problema – Dewpoint</translation>
    </message>
    <message>
        <source>Write to those who gave you Dewpoint: what you did, what you expected, and what happened instead. Add the text below, and, if you can, the project file and a screenshot. Nothing is sent by itself.</source>
        <translation>Escriba a quienes le dieron Dewpoint: qué hizo, qué esperaba y qué ocurrió en su lugar. Añada el texto de abajo y, si puede, el archivo del proyecto y una captura de pantalla. Nada se envía por sí solo.</translation>
    </message>
    <message>
        <source>Text for the report</source>
        <translation>Texto para el informe</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the text, to be pasted into a mail or a form</source>
        <translation>Copiar el texto, para pegarlo en un correo o un formulario</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ProjectController</name>
    <message>
        <source>Click the thing or drag a box around it in any camera view.</source>
        <translation>Haz clic en la cosa o arrastra un recuadro a su alrededor en cualquier cámara.</translation>
    </message>
    <message>
        <source>Click the thing to follow in any image: its color is learned and tracking starts.</source>
        <translation>Haga clic en cualquier imagen sobre lo que quiere seguir: se aprende su color y empieza el seguimiento.</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Abrir un proyecto</translation>
    </message>
    <message>
        <source>Dewpoint projects (*.toml);;All files (*)</source>
        <translation>Proyectos de Dewpoint (*.toml);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Recovered. Save the project to keep it.</source>
        <translation>Recuperado. Guarde el proyecto para conservarlo.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::QuickStart</name>
    <message>
        <source>The cameras confirm where the target is.</source>
        <translation>Las cámaras confirman dónde está el objetivo.</translation>
    </message>
    <message>
        <source>Something else fits about as well. Press X and drag the target to where it is.</source>
        <translation>Otra cosa encaja casi igual de bien. Pulse X y arrastre el objetivo adonde está.</translation>
    </message>
    <message>
        <source>Not found yet, or not seen for less than a second.</source>
        <translation>Aún no encontrado, o sin verse desde hace menos de un segundo.</translation>
    </message>
    <message>
        <source>Not seen for a second. The line at the bottom says why.</source>
        <translation>Sin verse desde hace un segundo. La línea de abajo dice por qué.</translation>
    </message>
    <message>
        <source>Quick start – Dewpoint</source>
        <translation>Primeros pasos – Dewpoint</translation>
    </message>
    <message>
        <source>What you see</source>
        <translation>Qué se ve</translation>
    </message>
    <message>
        <source>Each camera view shows its image, and over it what the program believes. The bird&apos;s-eye view shows the same in the room.</source>
        <translation>Cada vista de cámara muestra su imagen y, encima, lo que el programa cree. La vista de pájaro muestra lo mismo en la sala.</translation>
    </message>
    <message>
        <source>How sure it is</source>
        <translation>Qué tan seguro está</translation>
    </message>
    <message>
        <source>How to begin</source>
        <translation>Cómo empezar</translation>
    </message>
    <message>
        <source>1.  Open one video per camera, or connect cameras: File › New project (%1). Or try the demo first.</source>
        <translation>1.  Abra un vídeo por cámara o conecte cámaras: Archivo › Proyecto nuevo (%1). O pruebe antes la demo.</translation>
    </message>
    <message>
        <source>2.  Give the calibration of the cameras, or make one: menu Calibration (%1 to begin by hand). Without it, targets are tracked in the images only.</source>
        <translation>2.  Indique la calibración de las cámaras o haga una: menú Calibración (%1 para empezar a mano). Sin ella, los objetivos se siguen solo en las imágenes.</translation>
    </message>
    <message>
        <source>3.  Click the thing to follow in any image. Its color is learned in all cameras, and tracking starts.</source>
        <translation>3.  Haga clic en cualquier imagen sobre lo que quiere seguir. Se aprende su color en todas las cámaras y empieza el seguimiento.</translation>
    </message>
    <message>
        <source>4.  Press %1 to play and to pause. Drag along the timeline to look back: every view shows that frame as it was.</source>
        <translation>4.  Pulse %1 para reproducir y pausar. Arrastre por la línea de tiempo para mirar atrás: cada vista muestra ese fotograma tal como era.</translation>
    </message>
    <message>
        <source>5.  Export the trajectory: File › Export trajectory (%1).</source>
        <translation>5.  Exporte la trayectoria: Archivo › Exportar la trayectoria (%1).</translation>
    </message>
    <message>
        <source>All signs…</source>
        <translation>Todos los signos…</translation>
    </message>
    <message>
        <source>Open the legend of all that is drawn over the images</source>
        <translation>Abrir la leyenda de todo lo que se dibuja sobre las imágenes</translation>
    </message>
    <message>
        <source>Manual…</source>
        <translation>Manual…</translation>
    </message>
    <message>
        <source>Open the manual</source>
        <translation>Abrir el manual</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this window</source>
        <translation>Cerrar esta ventana</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentList</name>
    <message>
        <source>The file is gone</source>
        <translation>El archivo ya no existe</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecentMenu</name>
    <message>
        <source>Nothing yet</source>
        <translation>Nada todavía</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>Olvidar estos</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RecoveryOffer</name>
    <message>
        <source>Dewpoint did not end properly. Unsaved work on “%1” is from %2.</source>
        <translation>Dewpoint no terminó correctamente. El trabajo sin guardar en «%1» es de %2.</translation>
    </message>
    <message>
        <source>Recover it</source>
        <translation>Recuperarlo</translation>
    </message>
    <message>
        <source>Throw it away</source>
        <translation>Descartarlo</translation>
    </message>
    <message>
        <source>Unsaved work on “%1” was thrown away.</source>
        <translation>El trabajo sin guardar en «%1» se ha descartado.</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Recuperarlo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RigPlanner</name>
    <message>
        <source>Put %1 here: x %2, y %3, z %4. Then %5 of the volume is within %6, instead of %7.</source>
        <translation>Ponga %1 aquí: x %2, y %3, z %4. Entonces el %5 del volumen queda dentro de %6, en vez del %7.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunAlerts</name>
    <message>
        <source>No camera was bumped.</source>
        <translation>No se ha movido ninguna cámara.</translation>
    </message>
    <message>
        <source>%1 cannot be solved again now.</source>
        <translation>%1 no puede resolverse de nuevo ahora.</translation>
    </message>
    <message>
        <source>Re-solve %1</source>
        <translation>Resolver de nuevo %1</translation>
    </message>
    <message>
        <source>%1 is calibrated as it stands now. Undo takes it back.</source>
        <translation>%1 queda calibrada como está ahora. Deshacer lo revierte.</translation>
    </message>
    <message>
        <source>The target was %1 beside where the others see it, and is %2 now.</source>
        <translation>El objetivo estaba a %1 de donde lo ven las demás, y ahora a %2.</translation>
    </message>
    <message>
        <source>Done: %1. Undo takes it back.</source>
        <translation>Hecho: %1. Deshacer lo revierte.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::RunDetails</name>
    <message>
        <source>median %1, 99 of 100 within %2, longest %3</source>
        <translation>mediana %1, 99 de 100 por debajo de %2, máximo %3</translation>
    </message>
    <message>
        <source>none is set</source>
        <translation>no se fijó ninguno</translation>
    </message>
    <message>
        <source>%1, kept in %2 % of the iterations of this run</source>
        <translation>%1, cumplido en el %2 % de las iteraciones de esta ejecución</translation>
    </message>
    <message>
        <source>Time per iteration, median</source>
        <translation>Tiempo por iteración, mediana</translation>
    </message>
    <message>
        <source>From a frame to its estimate</source>
        <translation>De un fotograma a su estimación</translation>
    </message>
    <message>
        <source>Time budget per iteration</source>
        <translation>Límite de tiempo por iteración</translation>
    </message>
    <message>
        <source>Effective sample size</source>
        <translation>Tamaño efectivo de la muestra</translation>
    </message>
    <message>
        <source>Iterations since the start</source>
        <translation>Iteraciones desde el inicio</translation>
    </message>
    <message>
        <source>Frames skipped</source>
        <translation>Fotogramas omitidos</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Semilla aleatoria</translation>
    </message>
    <message>
        <source>Kept of the past</source>
        <translation>Pasado conservado</translation>
    </message>
    <message>
        <source>%1 of %2 particles</source>
        <translation>%1 de %2 partículas</translation>
    </message>
    <message>
        <source>%1 of %2 MB</source>
        <translation>%1 de %2 MB</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::SessionController</name>
    <message>
        <source>Restart the run? What was tracked so far is lost.</source>
        <translation>¿Reiniciar la ejecución? Se pierde lo seguido hasta ahora.</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>Use image size</source>
        <translation>Tomar el tamaño de las imágenes</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ShortcutEditor</name>
    <message>
        <source>Shortcuts</source>
        <translation>Atajos</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search actions</source>
        <translation>Buscar acciones</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Atajo</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Qué hace</translation>
    </message>
    <message>
        <source>Actions and their shortcuts</source>
        <translation>Acciones y sus atajos</translation>
    </message>
    <message>
        <source>Click here and press the new keys of the chosen action</source>
        <translation>Haga clic aquí y pulse las nuevas teclas de la acción elegida</translation>
    </message>
    <message>
        <source>New shortcut</source>
        <translation>Atajo nuevo</translation>
    </message>
    <message>
        <source>No shortcut</source>
        <translation>Sin atajo</translation>
    </message>
    <message>
        <source>Take the shortcut of the chosen action away</source>
        <translation>Quitar el atajo de la acción elegida</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restablecer todo</translation>
    </message>
    <message>
        <source>All shortcuts as they were at first</source>
        <translation>Todos los atajos como al principio</translation>
    </message>
    <message>
        <source>Choose an action, click into the field below and press the new keys.</source>
        <translation>Elija una acción, haga clic en el campo de abajo y pulse las nuevas teclas.</translation>
    </message>
    <message>
        <source>“%1” has no shortcut now.</source>
        <translation>«%1» ya no tiene atajo.</translation>
    </message>
    <message>
        <source>All shortcuts are as they were at first.</source>
        <translation>Todos los atajos están como al principio.</translation>
    </message>
    <message>
        <source>“%1” is now %2.</source>
        <translation>«%1» es ahora %2.</translation>
    </message>
    <message>
        <source>“%1” is now %2; “%3” has lost it.</source>
        <translation>«%1» es ahora %2; «%3» lo ha perdido.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close; changed shortcuts are kept already</source>
        <translation>Cerrar; los atajos cambiados ya están guardados</translation>
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
        <source>How fast the recording is played. Live cameras are always tracked as they come.</source>
        <translation>Con qué rapidez se reproduce la grabación. Las cámaras en vivo se siguen siempre según llegan sus imágenes.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
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
        <translation>Probar la demo</translation>
    </message>
    <message>
        <source>Recent projects</source>
        <translation>Proyectos recientes</translation>
    </message>
    <message>
        <source>You can also drop a project or videos onto this window.</source>
        <translation>También puede soltar un proyecto o vídeos sobre esta ventana.</translation>
    </message>
    <message>
        <source>Watch it converge</source>
        <translation>Vea cómo converge</translation>
    </message>
    <message>
        <source>A cloud of guesses slides along a line of sight and snaps onto the ball.</source>
        <translation>Una nube de suposiciones se desliza por una línea de visión y se cierra sobre la pelota.</translation>
    </message>
    <message>
        <source>Hidden for a second</source>
        <translation>Oculta durante un segundo</translation>
    </message>
    <message>
        <source>A box passes in front of the ball. One camera is enough to keep it.</source>
        <translation>Una caja pasa ante la pelota. Basta una cámara para no perderla.</translation>
    </message>
    <message>
        <source>Three more balls of the same color lie around. Only one moves.</source>
        <translation>Hay otras tres pelotas del mismo color alrededor. Solo una se mueve.</translation>
    </message>
    <message>
        <source>People in an office</source>
        <translation>Personas en una oficina</translation>
    </message>
    <message>
        <source>Four cameras carve everybody out of space, and give each a number.</source>
        <translation>Cuatro cámaras esculpen a cada persona en el espacio y le dan un número.</translation>
    </message>
    <message>
        <source>One camera and a box</source>
        <translation>Una cámara y un recuadro</translation>
    </message>
    <message>
        <source>No calibration: a box in the image is followed by its colors.</source>
        <translation>Sin calibración: un recuadro en la imagen se sigue por sus colores.</translation>
    </message>
    <message>
        <source>Calibrate by hand</source>
        <translation>Calibrar a mano</translation>
    </message>
    <message>
        <source>Drag a grid over the images until it lies on the floor.</source>
        <translation>Arrastre una cuadrícula sobre las imágenes hasta que coincida con el suelo.</translation>
    </message>
    <message>
        <source>Follow colored objects in 3D with ordinary cameras.</source>
        <translation>Siga objetos de color en 3D con cámaras corrientes.</translation>
    </message>
    <message>
        <source>Two simulated cameras see a pink ball; a particle filter finds it and follows it through space. Pause, look back, change everything: nothing can break.</source>
        <translation>Dos cámaras simuladas ven una pelota rosa; un filtro de partículas la encuentra y la sigue por el espacio. Pause, mire atrás, cámbielo todo: nada se puede estropear.</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Su propio material</translation>
    </message>
    <message>
        <source>Open videos…</source>
        <translation>Abrir vídeos…</translation>
    </message>
    <message>
        <source>One recording per camera</source>
        <translation>Una grabación por cámara</translation>
    </message>
    <message>
        <source>Use cameras…</source>
        <translation>Usar cámaras…</translation>
    </message>
    <message>
        <source>Connected ones, or network streams</source>
        <translation>Conectadas o flujos de red</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>Abrir un proyecto…</translation>
    </message>
    <message>
        <source>One that was saved before</source>
        <translation>Uno guardado antes</translation>
    </message>
    <message>
        <source>Four balls alike</source>
        <translation>Cuatro bolas iguales</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::StatusBarPanel</name>
    <message>
        <source>playing</source>
        <translation>en marcha</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pausa</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>terminado</translation>
    </message>
    <message>
        <source>Frame shown, of all frames</source>
        <translation>Fotograma mostrado, de todos</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Frames tracked per second</source>
        <translation>Fotogramas seguidos por segundo</translation>
    </message>
    <message>
        <source>Estimated position of the target in the room</source>
        <translation>Posición estimada del objetivo en la sala</translation>
    </message>
    <message>
        <source>frame %1 / %2</source>
        <translation>fotograma %1 / %2</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>fotograma %1</translation>
    </message>
    <message>
        <source>x %1  y %2  z %3</source>
        <translation>x %1  y %2  z %3</translation>
    </message>
    <message>
        <source>tracking again</source>
        <translation>siguiendo de nuevo</translation>
    </message>
    <message>
        <source>looking back</source>
        <translation>mirando atrás</translation>
    </message>
    <message>
        <source>Playing, paused, at the end, looking back at an earlier moment, or tracking it again</source>
        <translation>En marcha, en pausa, al final, mirando un momento anterior o siguiéndolo de nuevo</translation>
    </message>
    <message>
        <source>held where it is thought to be</source>
        <translation>se mantiene donde se cree que está</translation>
    </message>
    <message>
        <source>click it or drag a box around it</source>
        <translation>haz clic o arrastra un recuadro a su alrededor</translation>
    </message>
    <message>
        <source>x %1  y %2  %3 × %4</source>
        <translation>x %1  y %2  %3 × %4</translation>
    </message>
    <message>
        <source>● people: %1</source>
        <translation>● personas: %1</translation>
    </message>
    <message>
        <source>○ people: %1, searching</source>
        <translation>○ personas: %1, buscando</translation>
    </message>
    <message>
        <source>others fit as well: press X, drag the target</source>
        <translation>otros encajan igual: pulse X y arrastre el objetivo</translation>
    </message>
    <message>
        <source>Held: the cameras confirm the estimate. Ambiguous: something else fits about as well. Lost: not held for a second.</source>
        <translation>Seguido: las cámaras confirman la estimación. Ambiguo: otra cosa encaja casi igual de bien. Perdido: no seguido desde hace un segundo.</translation>
    </message>
    <message>
        <source>± %1</source>
        <translation>± %1</translation>
    </message>
    <message>
        <source>How exactly the position is known: the standard deviation in 3D, x, y and z together (the plots show each)</source>
        <translation>Con qué exactitud se conoce la posición: la desviación típica en 3D, x, y y z juntas (los gráficos muestran cada una)</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>Speed of the target in the room</source>
        <translation>Velocidad del objetivo en la sala</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
    <message>
        <source>Times, particles, and what is kept of the past</source>
        <translation>Tiempos, partículas y lo que se conserva del pasado</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TargetPanel</name>
    <message>
        <source>Targets</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Name of the target, in views and files</source>
        <translation>Nombre del objetivo, en vistas y archivos</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>Radius of the ball, 0 to 2,000 mm. Unknown: it is estimated.</source>
        <translation>Radio de la bola, de 0 a 2000 mm. Desconocido: se estima.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automática</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>bola</translation>
    </message>
    <message>
        <source>any</source>
        <translation>cualquiera</translation>
    </message>
    <message>
        <source>Ball: its outline is a circle in every image. Any: its extent is learned, and its center is that of its color. Automatic: the images decide. Only method dewpoint uses this.</source>
        <translation>Bola: su contorno es un círculo en cada imagen. Cualquiera: se aprende su extensión, y su centro es el de su color. Automática: deciden las imágenes. Solo el método dewpoint lo usa.</translation>
    </message>
    <message>
        <source>No target yet: click the thing to follow in any camera image.</source>
        <translation>Aún no hay objetivo: haga clic en cualquier imagen sobre lo que quiere seguir.</translation>
    </message>
    <message>
        <source>The color of a target is learned by clicking it in a camera image.</source>
        <translation>El color de un objetivo se aprende haciendo clic sobre él en una imagen de cámara.</translation>
    </message>
    <message>
        <source>Rename target</source>
        <translation>Renombrar el objetivo</translation>
    </message>
    <message>
        <source>Change radius</source>
        <translation>Cambiar el radio</translation>
    </message>
    <message>
        <source>Change shape</source>
        <translation>Cambiar la forma</translation>
    </message>
    <message>
        <source>Remove target</source>
        <translation>Quitar el objetivo</translation>
    </message>
    <message>
        <source>Click the thing or drag a box around it in any camera view: it is followed from there on.</source>
        <translation>Haz clic en la cosa o arrastra un recuadro a su alrededor en cualquier cámara: se sigue desde ahí.</translation>
    </message>
    <message>
        <source>No box at this moment.</source>
        <translation>Sin recuadro en este momento.</translation>
    </message>
    <message>
        <source>%1, in %2
Center %3, %4, size %5 × %6
Similarity %7
Effective sample size %8 of %9</source>
        <translation>%1, en %2
Centro %3, %4, tamaño %5 × %6
Similitud %7
Tamaño efectivo de la muestra %8 de %9</translation>
    </message>
    <message>
        <source>Spread %1</source>
        <translation>Dispersión %1</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>radius %1</source>
        <translation>radio %1</translation>
    </message>
    <message>
        <source>radius %1 (found)</source>
        <translation>radio %1 (encontrado)</translation>
    </message>
    <message>
        <source>radius unknown</source>
        <translation>radio desconocido</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Add target</source>
        <translation>Añadir objetivo</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Recuadro</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Aprender</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ThreadCountDialog</name>
    <message>
        <source>Filter threads</source>
        <translation>Hilos del filtro</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Hilos</translation>
    </message>
    <message>
        <source>as suits this machine</source>
        <translation>lo que convenga a este equipo</translation>
    </message>
    <message>
        <source>How many threads share the work of the filter; results are the same with any number</source>
        <translation>Cuántos hilos se reparten el trabajo del filtro; los resultados son los mismos con cualquier número</translation>
    </message>
    <message>
        <source>Used from the next frame on.</source>
        <translation>Se usa a partir del próximo fotograma.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>Keep this number</source>
        <translation>Conservar este número</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>No cambiar nada</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Timeline</name>
    <message>
        <source>Memory for going back in the run: images, particles and copies of the method. When it is full, older moments keep their estimates only.</source>
        <translation>Memoria para retroceder en la ejecución: imágenes, partículas y copias del método. Cuando se llena, los momentos antiguos solo conservan sus estimaciones.</translation>
    </message>
    <message>
        <source>Nothing tracked yet: play (Space), then drag here through time.</source>
        <translation>Aún no hay seguimiento: reproduzca (Espacio) y después arrastre aquí por el tiempo.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>The change holds from now on. “%1” shows what it makes of this moment.</source>
        <translation>El cambio vale a partir de ahora. «%1» muestra qué hace con este momento.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TouchedInstantList</name>
    <message>
        <source>The ball %1</source>
        <translation>La pelota %1</translation>
    </message>
    <message>
        <source>What the ball does at the moment</source>
        <translation>Qué hace la pelota en el momento</translation>
    </message>
    <message>
        <source>Three places of the floor, or a fall, tell where up is</source>
        <translation>Tres lugares del suelo, o una caída, dicen dónde es arriba</translation>
    </message>
    <message>
        <source>Take this moment</source>
        <translation>Tomar este momento</translation>
    </message>
    <message>
        <source>The moment that the images show is one at which the ball does this</source>
        <translation>En el momento que muestran las imágenes la pelota hace esto</translation>
    </message>
    <message>
        <source>Remove moment</source>
        <translation>Quitar momento</translation>
    </message>
    <message>
        <source>Take the chosen moment off the list</source>
        <translation>Quitar de la lista el momento elegido</translation>
    </message>
    <message>
        <source>Moments taken</source>
        <translation>Momentos tomados</translation>
    </message>
    <message>
        <source>Double click or Enter shows the moment</source>
        <translation>Doble clic o Intro muestra el momento</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryModel</name>
    <message>
        <source>● held</source>
        <translation>● seguido</translation>
    </message>
    <message>
        <source>○ not held</source>
        <translation>○ no seguido</translation>
    </message>
    <message>
        <source>time, s</source>
        <translation>tiempo, s</translation>
    </message>
    <message>
        <source>Seconds, of the frame</source>
        <translation>Segundos, del fotograma</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>fotograma</translation>
    </message>
    <message>
        <source>Frame, counted from 1</source>
        <translation>Fotograma, contado desde 1</translation>
    </message>
    <message>
        <source>target</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>Name of the target</source>
        <translation>Nombre del objetivo</translation>
    </message>
    <message>
        <source>%1, m</source>
        <translation>%1, m</translation>
    </message>
    <message>
        <source>Position in the room, meters</source>
        <translation>Posición en la sala, metros</translation>
    </message>
    <message>
        <source>σ%1, mm</source>
        <translation>σ%1, mm</translation>
    </message>
    <message>
        <source>Standard deviation of the position, millimeters</source>
        <translation>Desviación típica de la posición, milímetros</translation>
    </message>
    <message>
        <source>speed, m/s</source>
        <translation>veloc., m/s</translation>
    </message>
    <message>
        <source>Speed, meters per second: fitted over five frames</source>
        <translation>Velocidad, metros por segundo: ajustada en cinco fotogramas</translation>
    </message>
    <message>
        <source>cameras</source>
        <translation>cámaras</translation>
    </message>
    <message>
        <source>Cameras that see the target</source>
        <translation>Cámaras que ven el objetivo</translation>
    </message>
    <message>
        <source>existence</source>
        <translation>existencia</translation>
    </message>
    <message>
        <source>Probability that the target is where the estimate says</source>
        <translation>Probabilidad de que el objetivo esté donde dice la estimación</translation>
    </message>
    <message>
        <source>state</source>
        <translation>estado</translation>
    </message>
    <message>
        <source>◆ corrected</source>
        <translation>◆ corregido</translation>
    </message>
    <message>
        <source>◇ ambiguous</source>
        <translation>◇ ambiguo</translation>
    </message>
    <message>
        <source>Held: the cameras confirm the estimate. Ambiguous: something else fits about as well. Corrected: you said where the target is</source>
        <translation>Seguido: las cámaras confirman la estimación. Ambiguo: otra cosa encaja casi igual de bien. Corregido: usted dijo dónde está el objetivo</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::TrajectoryPanel</name>
    <message>
        <source>Trajectory</source>
        <translation>Trayectoria</translation>
    </message>
    <message>
        <source>Speed and height over time</source>
        <translation>Velocidad y altura en el tiempo</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message numerus="yes">
        <source>%n rows are on the clipboard as CSV.</source>
        <translation>
            <numerusform>%n fila está en el portapapeles como CSV.</numerusform>
            <numerusform>%n filas están en el portapapeles como CSV.</numerusform>
        </translation>
    </message>
    <message>
        <source>The trajectory appears here as soon as the target is tracked.</source>
        <translation>La trayectoria aparece aquí en cuanto se sigue el objetivo.</translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n muestra</numerusform>
            <numerusform>%n muestras</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples, no gaps</source>
        <translation>
            <numerusform>%n muestra, sin huecos</numerusform>
            <numerusform>%n muestras, sin huecos</numerusform>
        </translation>
    </message>
    <message>
        <source>The boxes are on the clipboard as CSV.</source>
        <translation>Los recuadros están en el portapapeles como CSV.</translation>
    </message>
    <message>
        <source>Remove the correction</source>
        <translation>Quitar la corrección</translation>
    </message>
    <message>
        <source>Speed and height appear when tracking runs.</source>
        <translation>La velocidad y la altura aparecen durante el seguimiento.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::UncertaintyMapForm</name>
    <message>
        <source>Show the map in the bird&apos;s-eye view</source>
        <translation>Mostrar el mapa en la vista de pájaro</translation>
    </message>
    <message>
        <source>How far off a target is expected to be at each place; it follows every move of a camera</source>
        <translation>Cuánto se espera que se desvíe un objetivo en cada lugar; sigue cada movimiento de una cámara</translation>
    </message>
    <message>
        <source>Colors show</source>
        <translation>Los colores muestran</translation>
    </message>
    <message>
        <source>the expected error</source>
        <translation>el error esperado</translation>
    </message>
    <message>
        <source>the number of cameras</source>
        <translation>el número de cámaras</translation>
    </message>
    <message>
        <source>What the colors show</source>
        <translation>Qué muestran los colores</translation>
    </message>
    <message>
        <source>The expected error (standard deviation along the worst direction), or how many cameras see a place</source>
        <translation>El error esperado (desviación estándar en la peor dirección), o cuántas cámaras ven un lugar</translation>
    </message>
    <message>
        <source>Good enough</source>
        <translation>Suficiente</translation>
    </message>
    <message>
        <source>The error that is good enough: up to it the map is blue, and it is what the sentence and the search for a place go by</source>
        <translation>El error que basta: hasta él el mapa es azul, y por él se rigen la frase y la búsqueda de un lugar</translation>
    </message>
    <message>
        <source>Error of a sighting</source>
        <translation>Error de una observación</translation>
    </message>
    <message>
        <source>How far off a target is found in an image, in pixels (one standard deviation)</source>
        <translation>Cuánto se desvía el objetivo hallado en una imagen, en píxeles (una desviación estándar)</translation>
    </message>
    <message>
        <source>Layer at</source>
        <translation>Capa a</translation>
    </message>
    <message>
        <source>Show the map in a horizontal layer</source>
        <translation>Mostrar el mapa en una capa horizontal</translation>
    </message>
    <message>
        <source>Height of the layer</source>
        <translation>Altura de la capa</translation>
    </message>
    <message>
        <source>Height of the layer above the floor</source>
        <translation>Altura de la capa sobre el suelo</translation>
    </message>
    <message>
        <source>Height of the layer in meters</source>
        <translation>Altura de la capa en metros</translation>
    </message>
    <message>
        <source>Volume: surfaces around what is good and what is fair</source>
        <translation>Volumen: superficies en torno a lo bueno y lo aceptable</translation>
    </message>
    <message>
        <source>Show through the room where the error is at most 0.4, 1 and 2 times what is good enough, or where two, three and four cameras see</source>
        <translation>Mostrar en toda la sala dónde el error es como mucho 0,4, 1 y 2 veces lo suficiente, o dónde ven dos, tres y cuatro cámaras</translation>
    </message>
    <message>
        <source>Volume from x, y, z</source>
        <translation>Volumen desde x, y, z</translation>
    </message>
    <message>
        <source>to x, y, z</source>
        <translation>hasta x, y, z</translation>
    </message>
    <message>
        <source>Volume from %1</source>
        <translation>Volumen desde %1</translation>
    </message>
    <message>
        <source>Where the volume begins, in meters</source>
        <translation>Dónde empieza el volumen, en metros</translation>
    </message>
    <message>
        <source>Volume to %1</source>
        <translation>Volumen hasta %1</translation>
    </message>
    <message>
        <source>Where the volume ends, in meters</source>
        <translation>Dónde acaba el volumen, en metros</translation>
    </message>
    <message>
        <source>Like the reference grid</source>
        <translation>Como la cuadrícula de referencia</translation>
    </message>
    <message>
        <source>The volume above the reference grid, up to the highest camera</source>
        <translation>El volumen sobre la cuadrícula de referencia, hasta la cámara más alta</translation>
    </message>
    <message>
        <source>%1 of the volume within %2, %3 seen by fewer than two cameras</source>
        <translation>%1 del volumen dentro de %2, %3 visto por menos de dos cámaras</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewButtons</name>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>Look from above: X to the right, Y up. Drag to move, wheel to zoom, double click to see everything.</source>
        <translation>Vista desde arriba: X a la derecha, Y hacia arriba. Arrastrar para mover, rueda para acercar, doble clic para verlo todo.</translation>
    </message>
    <message>
        <source>Look from the front: X to the right, Z up. Drag to move, wheel to zoom, double click to see everything.</source>
        <translation>Vista desde el frente: X a la derecha, Z hacia arriba. Arrastrar para mover, rueda para acercar, doble clic para verlo todo.</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>See everything again, in the same view. Double click does it too.</source>
        <translation>Verlo todo de nuevo, en la misma vista. El doble clic también lo hace.</translation>
    </message>
    <message>
        <source>Perspective view. Drag to orbit, Shift-drag to move, scroll to zoom, double-click to show everything.</source>
        <translation>Vista en perspectiva. Arrastrar para girar, Mayús y arrastrar para mover, rueda para acercar, doble clic para verlo todo.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::ViewPictures</name>
    <message>
        <source>Save picture as PNG…</source>
        <translation>Guardar la imagen como PNG…</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copiar la imagen</translation>
    </message>
    <message>
        <source>Save a picture of %1</source>
        <translation>Guardar una imagen de %1</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>Saved the picture %1.</source>
        <translation>Se guardó la imagen %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::VolumeForm</name>
    <message>
        <source>From X, Y, Z</source>
        <translation>Desde X, Y, Z</translation>
    </message>
    <message>
        <source>To X, Y, Z</source>
        <translation>Hasta X, Y, Z</translation>
    </message>
    <message>
        <source>Volume of interest from %1</source>
        <translation>Volumen de interés desde %1</translation>
    </message>
    <message>
        <source>Volume of interest to %1</source>
        <translation>Volumen de interés hasta %1</translation>
    </message>
    <message>
        <source>Where the volume of interest begins, in meters; targets are searched for in it alone</source>
        <translation>Dónde empieza el volumen de interés, en metros; los objetivos se buscan solo en él</translation>
    </message>
    <message>
        <source>Where the volume of interest ends, in meters; targets are searched for in it alone</source>
        <translation>Dónde termina el volumen de interés, en metros; los objetivos se buscan solo en él</translation>
    </message>
    <message>
        <source>From the cameras</source>
        <translation>De las cámaras</translation>
    </message>
    <message>
        <source>Search for targets in the box around what at least two cameras see</source>
        <translation>Buscar objetivos en la caja que rodea lo que ven al menos dos cámaras</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Search for targets anywhere</source>
        <translation>Buscar objetivos en cualquier lugar</translation>
    </message>
    <message>
        <source>Set volume of interest</source>
        <translation>Fijar el volumen de interés</translation>
    </message>
    <message>
        <source>Remove volume of interest</source>
        <translation>Quitar el volumen de interés</translation>
    </message>
    <message>
        <source>Targets are searched for in this box alone.</source>
        <translation>Los objetivos se buscan solo en esta caja.</translation>
    </message>
    <message>
        <source>None: targets are searched for anywhere. The numbers are what the cameras see; change one to search in a box.</source>
        <translation>Ninguno: los objetivos se buscan en cualquier lugar. Los números son lo que ven las cámaras; cambie uno para buscar en una caja.</translation>
    </message>
    <message>
        <source>None: targets are searched for anywhere. Change a number to search in a box.</source>
        <translation>Ninguno: los objetivos se buscan en cualquier lugar. Cambie un número para buscar en una caja.</translation>
    </message>
    <message>
        <source>Change volume of interest</source>
        <translation>Cambiar el volumen de interés</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrationPage</name>
    <message>
        <source>Nudge the cameras by hand until they are roughly right. Then wave the ball, or a stick with two balls, through the whole volume, and refine.</source>
        <translation>Ajuste las cámaras a mano hasta que estén más o menos bien. Después agite la pelota, o una vara con dos pelotas, por todo el volumen y refine.</translation>
    </message>
    <message>
        <source>Nudge the cameras by hand until they are roughly right. A recording of a ball, or a stick with two balls, waved through the whole volume then makes them exact.</source>
        <translation>Ajuste las cámaras a mano hasta que estén más o menos bien. La grabación de una pelota, o de una vara con dos pelotas, agitada por todo el volumen las hace exactas.</translation>
    </message>
    <message>
        <source>Where the floor is</source>
        <translation>Dónde está el suelo</translation>
    </message>
    <message>
        <source>Waving</source>
        <translation>Agitar</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Refinar</translation>
    </message>
    <message>
        <source>Wave</source>
        <translation>Agitar</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>Se guardó %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandCalibrator</name>
    <message>
        <source>Press Start waving, and wave for half a minute where things are to be tracked.</source>
        <translation>Pulse «Empezar a agitar» y agite durante medio minuto donde se vaya a seguir.</translation>
    </message>
    <message>
        <source>Refine cameras with a waved stick</source>
        <translation>Refinar cámaras con una vara agitada</translation>
    </message>
    <message>
        <source>Refine cameras with a waved ball</source>
        <translation>Refinar cámaras con una pelota agitada</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandForm</name>
    <message>
        <source>the ball&apos;s diameter</source>
        <translation>el diámetro de la pelota</translation>
    </message>
    <message>
        <source>the ball&apos;s diameter, %1</source>
        <translation>el diámetro de la pelota, %1</translation>
    </message>
    <message>
        <source>the cameras as they are</source>
        <translation>las cámaras como están</translation>
    </message>
    <message>
        <source>a distance touched</source>
        <translation>una distancia tocada</translation>
    </message>
    <message>
        <source>Waved</source>
        <translation>Se agita</translation>
    </message>
    <message>
        <source>one ball</source>
        <translation>una pelota</translation>
    </message>
    <message>
        <source>a stick with two balls</source>
        <translation>una vara con dos pelotas</translation>
    </message>
    <message>
        <source>What is waved</source>
        <translation>Qué se agita</translation>
    </message>
    <message>
        <source>A stick also gives the size, better than anything else</source>
        <translation>Una vara da también el tamaño, mejor que nada</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Pelota</translation>
    </message>
    <message>
        <source>The target that is waved: its color is looked for</source>
        <translation>El objetivo que se agita: se busca su color</translation>
    </message>
    <message>
        <source>Second ball</source>
        <translation>Segunda pelota</translation>
    </message>
    <message>
        <source>The target at the other end of the stick</source>
        <translation>El objetivo del otro extremo de la vara</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Length of the stick</source>
        <translation>Longitud de la vara</translation>
    </message>
    <message>
        <source>From the middle of one ball to that of the other</source>
        <translation>Del centro de una pelota al de la otra</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source>Size from</source>
        <translation>Tamaño de</translation>
    </message>
    <message>
        <source>What gives the size</source>
        <translation>Qué da el tamaño</translation>
    </message>
    <message>
        <source>Images alone do not tell a large room from a small one: a diameter is good to about one percent, a distance to what you measure</source>
        <translation>Las imágenes solas no distinguen una sala grande de una pequeña: un diámetro vale hasta un uno por ciento, una distancia lo que usted mida</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Distance touched</source>
        <translation>Distancia tocada</translation>
    </message>
    <message>
        <source>Between the two places that the middle of the ball was held at</source>
        <translation>Entre los dos lugares donde se sostuvo el centro de la pelota</translation>
    </message>
    <message>
        <source>Off by up to</source>
        <translation>Error de hasta</translation>
    </message>
    <message>
        <source>How far cameras may be off</source>
        <translation>Cuánto pueden estar desplazadas las cámaras</translation>
    </message>
    <message>
        <source>How well the cameras are nudged: about how far each may be from its true place</source>
        <translation>Lo bien ajustadas que están: cuánto puede distar cada una de su lugar real</translation>
    </message>
    <message>
        <source>How much cameras may be turned</source>
        <translation>Cuánto pueden estar giradas las cámaras</translation>
    </message>
    <message>
        <source>About how far each may be turned from where it truly looks</source>
        <translation>Cuánto puede estar girada cada una respecto a donde mira de verdad</translation>
    </message>
    <message>
        <source>Find time offsets</source>
        <translation>Buscar desfases de tiempo</translation>
    </message>
    <message>
        <source>For cameras that do not take their images at the same instants</source>
        <translation>Para cámaras que no toman sus imágenes en los mismos instantes</translation>
    </message>
    <message>
        <source>Find focal lengths</source>
        <translation>Buscar distancias focales</translation>
    </message>
    <message>
        <source>For lenses that were never calibrated, or zoomed</source>
        <translation>Para objetivos nunca calibrados o con otro zoom</translation>
    </message>
    <message>
        <source>Find the distortion k1</source>
        <translation>Buscar la distorsión k1</translation>
    </message>
    <message>
        <source>The first coefficient of each lens; needs a ball seen up to the edges of the images</source>
        <translation>El primer coeficiente de cada objetivo; la pelota debe verse hasta los bordes de las imágenes</translation>
    </message>
    <message>
        <source>Only the selected span</source>
        <translation>Solo el tramo elegido</translation>
    </message>
    <message>
        <source>Look through the stretch selected in the timeline, not the whole recording</source>
        <translation>Examinar el tramo elegido en la línea de tiempo, no toda la grabación</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandOutcome</name>
    <message>
        <source>Refine cameras</source>
        <translation>Refinar cámaras</translation>
    </message>
    <message>
        <source>Find the ball in all images, and the cameras that explain them best</source>
        <translation>Encontrar la pelota en todas las imágenes, y las cámaras que mejor las explican</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop; the cameras stay as they are</source>
        <translation>Detener; las cámaras quedan como están</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>While it is pressed, the grid is drawn with the cameras as they were</source>
        <translation>Mientras se pulsa, la rejilla se dibuja con las cámaras como estaban</translation>
    </message>
    <message>
        <source>Use it anyway</source>
        <translation>Usarla de todos modos</translation>
    </message>
    <message>
        <source>Take these cameras although something seems to be wrong; it can be undone</source>
        <translation>Tomar estas cámaras aunque algo parece estar mal; se puede deshacer</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Guardar informe…</translation>
    </message>
    <message>
        <source>A page with all figures, residuals as arrows, coverage and a drawing in space</source>
        <translation>Una página con todas las cifras, residuos como flechas, cobertura y un dibujo en el espacio</translation>
    </message>
    <message>
        <source>Cameras found</source>
        <translation>Cámaras halladas</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Cámara</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>moved cm</source>
        <translation>movida cm</translation>
    </message>
    <message>
        <source>turned °</source>
        <translation>girada °</translation>
    </message>
    <message>
        <source>late ms</source>
        <translation>retraso ms</translation>
    </message>
    <message>
        <source>Root mean square distance between seen and projected balls</source>
        <translation>Distancia cuadrática media entre las pelotas vistas y las proyectadas</translation>
    </message>
    <message>
        <source>How far the camera is from where it was</source>
        <translation>Cuánto dista la cámara de donde estaba</translation>
    </message>
    <message>
        <source>How far it is turned from where it looked</source>
        <translation>Cuánto ha girado respecto a donde miraba</translation>
    </message>
    <message>
        <source>The cameras are as they were.</source>
        <translation>Las cámaras están como estaban.</translation>
    </message>
    <message>
        <source>Solutions without a part of the recording differ %1 times more than noise explains; the verdict includes that.</source>
        <translation>Las soluciones sin una parte de la grabación difieren %1 veces más de lo que explica el ruido; el veredicto lo incluye.</translation>
    </message>
    <message>
        <source>The fall says %1 m/s² (9.81 is expected).</source>
        <translation>La caída dice %1 m/s² (se espera 9,81).</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Guardar el informe</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Páginas web (*.html)</translation>
    </message>
    <message>
        <source>What was found of each camera; point at a heading to see what it means</source>
        <translation>Lo que se halló de cada cámara; señala un encabezado para ver qué significa</translation>
    </message>
    <message>
        <source>The cameras were changed since; this is about how they were refined.</source>
        <translation>Las cámaras se han cambiado desde entonces; esto se refiere a como quedaron al refinarlas.</translation>
    </message>
    <message>
        <source>By how much its images are later than the first camera&apos;s, beyond what was known</source>
        <translation>Cuánto se retrasan sus imágenes respecto a las de la primera cámara, además de lo ya conocido</translation>
    </message>
    <message>
        <source>That is less sure than the cameras were (off by up to %1): wave through more of the volume.</source>
        <translation>Es menos seguro que las cámaras de antes (desviadas hasta %1): agite por una parte mayor del volumen.</translation>
    </message>
    <message>
        <source>How late cameras are is kept in the project: images are put together by it from now on.</source>
        <translation>El retraso de las cámaras queda en el proyecto: desde ahora las imágenes se emparejan según él.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WandWaving</name>
    <message>
        <source>Collect where every camera sees the ball; beginning again forgets what was collected before</source>
        <translation>Reunir dónde ve cada cámara la pelota; empezar de nuevo olvida lo reunido antes</translation>
    </message>
    <message>
        <source>■ Stop waving</source>
        <translation>■ Dejar de agitar</translation>
    </message>
    <message>
        <source>● Start waving</source>
        <translation>● Empezar a agitar</translation>
    </message>
    <message>
        <source>Stop waving</source>
        <translation>Dejar de agitar</translation>
    </message>
    <message>
        <source>Start waving</source>
        <translation>Empezar a agitar</translation>
    </message>
    <message>
        <source>Nothing collected yet.</source>
        <translation>Aún no se ha reunido nada.</translation>
    </message>
    <message>
        <source>%1 collected.</source>
        <translation>%1 reunidos.</translation>
    </message>
    <message>
        <source>Every camera saw enough: stop, or refine.</source>
        <translation>Cada cámara vio bastante: pare o refine.</translation>
    </message>
    <message>
        <source>Go on: each camera should see the ball 150 times, in half of its image.</source>
        <translation>Siga: cada cámara debería ver la pelota 150 veces, en la mitad de su imagen.</translation>
    </message>
    <message>
        <source>Image sets left out because they came too fast: %1.</source>
        <translation>Conjuntos de imágenes omitidos por llegar demasiado rápido: %1.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::WindowMenus</name>
    <message>
        <source>Cameras</source>
        <translation>Cámaras</translation>
    </message>
    <message>
        <source>Choose this camera</source>
        <translation>Elegir esta cámara</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Choose this target</source>
        <translation>Elegir este objetivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;Calibration</source>
        <translation>&amp;Calibración</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>E&amp;jecución</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Abrir reciente</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vistas</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Show this view</source>
        <translation>Mostrar esta vista</translation>
    </message>
    <message>
        <source>Speak this language</source>
        <translation>Hablar este idioma</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Según el sistema</translation>
    </message>
</context>
</TS>
