{-# LANGUAGE OverloadedStrings #-}

-- |
-- Module      : Main
-- Description : The command line
--
-- From options to one call.
module Main
  ( main,
  )
where

import Control.Applicative (many, optional, some, (<|>))
import Control.Exception (SomeAsyncException, SomeException, fromException, handle, throwIO)
import Data.Maybe (fromMaybe)
import qualified Data.Text as Text
import qualified Data.Text.IO as Text
import Data.Version (showVersion)
import Dioptre.Command.Check (check, checkWithOriginal)
import Dioptre.Command.Compare (compare)
import Dioptre.Command.Conform (Trial (..), conform)
import Dioptre.Command.Explain (explain)
import Dioptre.Command.Format (Format (..))
import Dioptre.Command.Info (info)
import Dioptre.Command.Journal (newJournal)
import Dioptre.Command.New (new)
import Dioptre.Command.Oracle (oracle)
import Dioptre.Command.Render (Options (..), Output (..), render)
import Dioptre.Command.Run (firstNumber, readConfiguration, run)
import Dioptre.Command.View (ViewOptions (..), viewScene)
import Dioptre.Conformance.Oracle (profiles)
import Dioptre.Conformance.Suite (Selection (..))
import Dioptre.Files.Number (PictureNumber)
import Dioptre.Scene.Configuration (Configuration (..))
import Dioptre.Source.Language (Language (..), fromLocale, inLanguage, languageNames)
import Dioptre.Syntax.Value (integer, real)
import GHC.Conc (getNumProcessors, setNumCapabilities)
import GHC.IO.Encoding (mkTextEncoding, setFileSystemEncoding, setLocaleEncoding)
import GHC.IO.Exception (IOErrorType (ResourceVanished), ioe_type)
import Options.Applicative hiding (info, many, optional, some, (<|>))
import qualified Options.Applicative as Options
import Paths_dioptre (version)
import System.Environment (getArgs, getEnvironment)
import System.Exit (ExitCode (..), exitWith)
import System.IO (hPutStrLn, hSetEncoding, stderr, stdout, utf8)
import Prelude hiding (compare)

-- | What to do, with the options that every command has.
data Command = Command
  { commandSettings :: Settings,
    commandWork :: Work
  }

-- | How to speak, and how many processors to use.
data Settings = Settings
  { settingLanguage :: Maybe Language,
    settingQuiet :: Bool,
    settingThreads :: Maybe Int
  }

data Work
  = Configured
  | Render (PictureNumber -> Options)
  | Check Bool Format [FilePath]
  | New FilePath
  | Explain Format FilePath Int Int
  | Compare FilePath FilePath
  | Info
  | Oracle
  | Conform Trial
  | View ViewOptions (Maybe FilePath)

main :: IO ()
main = do
  -- Before anything is read or said: UTF-8, whatever the locale; names of files keep their bytes.
  mkTextEncoding "UTF-8//ROUNDTRIP" >>= setFileSystemEncoding
  setLocaleEncoding utf8
  mapM_ (`hSetEncoding` utf8) [stdout, stderr]
  handle bug $ do
    configuration <- readConfiguration
    environment <- getEnvironment
    let locale = fromLocale (`lookup` environment)
        configured = either (const Nothing) (\(_, c, _) -> configurationLanguage c) configuration
        habitual = fromMaybe locale configured
    asked <- getArgs >>= handleParseResult . execParserPure defaultPrefs (program habitual) . joinCrop
    let settings = commandSettings asked
        l = fromMaybe habitual (settingLanguage settings)
        first = either (const minBound) (\(_, c, _) -> firstNumber c) configuration
    maybe getNumProcessors pure (settingThreads settings) >>= setNumCapabilities
    journal <- newJournal l (not (settingQuiet settings))
    exitWith =<< case commandWork asked of
      Configured -> run journal configuration
      Render options -> render journal (options first)
      Check original format paths -> (if original then checkWithOriginal else check) journal format paths
      New name -> new journal name
      Explain format path column row -> explain journal format path column row
      Compare a b -> compare journal a b
      Info -> ExitSuccess <$ Text.putStr (info l)
      Oracle -> oracle (Text.pack (showVersion version))
      Conform trial -> conform journal trial
      View options path -> viewScene journal options path

-- | The four numbers of @--crop@ as one argument, which is what the option parser can take.
joinCrop :: [String] -> [String]
joinCrop arguments = case arguments of
  "--crop" : rest | (numbers@[_, _, _, _], others) <- splitAt 4 rest -> ("--crop=" <> unwords numbers) : joinCrop others
  "--" : rest -> "--" : rest
  other : rest -> other : joinCrop rest
  [] -> []

-- | What was not foreseen is a mistake of ours, and says so; except that whoever stops reading our output, or stops us, means it.
bug :: SomeException -> IO a
bug e
  | Just code <- fromException e = throwIO (code :: ExitCode)
  | Just stop <- fromException e = throwIO (stop :: SomeAsyncException)
  | Just broken <- fromException e, ResourceVanished <- ioe_type broken = exitWith (ExitFailure 141)
  | otherwise = do
    hPutStrLn stderr ("dioptre: this is a bug of ours, please report it / ceci est une erreur de notre part, merci de la signaler\n" <> show e)
    exitWith (ExitFailure 70)

program :: Language -> ParserInfo Command
program l =
  Options.info
    (helpOption <*> versionOption <*> (commands <|> bareScene <|> configured))
    ( fullDesc
        <> failureCode 2
        <> header (say "dioptre - draws the picture that the rays of a scene see" "dioptre - dessine l'image que voient les rayons d'une scène")
        <> progDesc
          ( say
              "Without a command, runs what configuration.cfg says; with the path of a scene, renders it."
              "Sans commande, exécute ce que dit configuration.cfg\xA0; avec le chemin d'une scène, la dessine."
          )
        <> footer
          ( say
              "Exit codes: 0 done, 1 faults under check or --strict, or a difference, 2 wrong usage, 3 a file that cannot be read or written, 70 a bug of ours, 130 stopped by Ctrl-C."
              "Codes de sortie\xA0: 0 terminé, 1 fautes avec check ou --strict, ou une différence, 2 mauvais usage, 3 fichier illisible ou impossible à écrire, 70 erreur de notre part, 130 arrêté par Ctrl-C."
          )
    )
  where
    say = inLanguage l
    helpOption = abortOption (ShowHelpText Nothing) (long "help" <> short 'h' <> help (say "show this text" "afficher ce texte") <> hidden)
    versionOption = infoOption ("dioptre " <> showVersion version) (long "version" <> help (say "show the version" "afficher la version") <> hidden)

    commands =
      subparser . mconcat $
        [ entry "render" (say "draw a scene" "dessiner une scène") (rendering <$> renderOptions),
          entry "new" (say "write a scene to start from, NAME.txt, never over another file" "écrire une scène de départ, NOM.txt, jamais sur un autre fichier") (beginning <$> settings <*> path (say "NAME" "NOM")),
          entry "check" (say "tell what is wrong with scenes, and draw nothing" "dire ce qui ne va pas dans des scènes, sans dessiner") (checking <$> settings <*> original <*> format <*> some scene),
          entry "explain" (say "tell the story of one pixel: its ray, the shapes, the lights, the colour" "raconter l'histoire d'un pixel\xA0: son rayon, les formes, les lumières, la couleur") (explaining <$> settings <*> format <*> scene <*> place (say "COLUMN" "COLONNE") (say "from 0 at the left" "de 0, à gauche") <*> place (say "ROW" "LIGNE") (say "from 0 at the top" "de 0, en haut")),
          entry "view" (say "show a scene in the browser, where it can be changed and asked about" "montrer une scène dans le navigateur, où l'on peut la modifier et l'interroger") (viewingOf <$> settings <*> viewOptions <*> optional scene),
          entry "compare" (say "compare two scenes or pictures, pixel by pixel" "comparer deux scènes ou images, pixel par pixel") (comparing <$> settings <*> path "A" <*> path "B"),
          entry "info" (say "list applications, words and defaults" "énumérer applications, mots et valeurs par défaut") ((`Command` Info) <$> settings),
          entry "oracle" (say "answer the conformance protocol, a line for a line" "répondre au protocole de conformité, ligne par ligne") ((`Command` Oracle) <$> settings),
          entry "conform" (say "run the conformance suite against a port, a program that answers the protocol" "soumettre un portage, un programme qui répond au protocole, à la suite de conformité") (conforming <$> settings <*> trial),
          metavar (say "COMMAND" "COMMANDE")
        ]
    entry name what parser = command name (Options.info (helpOption <*> parser) (progDesc what <> failureCode 2))
    bareScene = rendering <$> renderOptions
    configured = (`Command` Configured) <$> settings

    rendering (s, make) = Command s (Render make)
    checking s o f paths = Command s (Check o f paths)
    beginning s name = Command s (New name)
    explaining s f path' column row = Command s (Explain f path' column row)
    place name what = argument (atLeast 0) (metavar name <> help what)
    comparing s a b = Command s (Compare a b)

    conforming s t = Command s (Conform t)

    viewingOf s options path' = Command s (View options path')
    viewOptions =
      ViewOptions
        <$> optional (option portNumber (long "port" <> metavar "N" <> help (say "the port of this machine where the page is (default: any free one)" "le port de cette machine où se trouve la page (par défaut\xA0: un port libre)")))
        <*> (not <$> switch (long "no-browser" <> help (say "only print the page's address" "afficher seulement l'adresse de la page")))
    portNumber = eitherReader $ \text -> case integer (Text.pack text) of
      Right n | n > 0 && n < 65536 -> Right n
      _ -> Left (say "an integer from 1 to 65535" "un entier de 1 à 65535")

    settings =
      Settings
        <$> optional (option language (long "language" <> metavar "en|fr" <> help (say "the language of messages" "la langue des messages")))
        <*> switch (long "quiet" <> short 'q' <> help (say "only the result, and what prevents it" "seulement le résultat, et ce qui l'empêche"))
        <*> optional (option (atLeast 1) (long "threads" <> metavar "N" <> help (say "use N processors (default: all)" "utiliser N processeurs (par défaut\xA0: tous)")))

    renderOptions = assemble <$> settings <*> scene <*> output <*> size "width" (say "W" "L") <*> size "height" "H" <*> sampling <*> crop <*> strict
    assemble s path' out w h n part isStrict = (s, \first -> Options path' (maybe (Numbered first) ToFile out) w h n part isStrict)
    output = optional (strOption (long "output" <> short 'o' <> metavar (say "FILE.png" "FICHIER.png") <> help (say "where the picture goes (default: NAME_NNN.png here, never over another)" "où va l'image (par défaut\xA0: NOM_NNN.png ici, jamais sur une autre)") <> action "file"))
    size name letter = optional (option (atLeast 1) (long name <> metavar letter <> help (say "instead of the scene's" "au lieu de celle de la scène")))
    sampling = optional (option (atLeast 1) (long "sampling" <> metavar "N" <> help (say "rays through each pixel" "rayons par pixel")))
    crop = optional (option fourNumbers (long "crop" <> metavar (say "X Y W H" "X Y L H") <> help (say "only this part: from column X, row Y" "seulement cette partie, depuis la colonne X, ligne Y")))
    fourNumbers = eitherReader $ \text -> case traverse (integer . Text.pack) (words text) of
      Right [x, y, w, h] -> Right (x, y, w, h)
      _ -> Left (say "four integers: column, row, width, height" "quatre entiers\xA0: colonne, ligne, largeur, hauteur")
    strict = switch (long "strict" <> help (say "draw nothing if the scene has faults" "ne rien dessiner si la scène a des fautes"))

    trial = Trial <$> selection <*> seconds <*> format <*> suite <*> path (say "COMMAND" "COMMANDE") <*> many (strArgument (metavar "ARGUMENT"))
    selection =
      Selection
        <$> many (strOption (long "profile" <> metavar "P" <> help (say "only this profile (may be repeated)" "seulement ce profil (peut être répété)") <> completeWith (map (Text.unpack . fst) profiles)))
        <*> optional (strOption (long "rule" <> metavar "R" <> help (say "only this rule, or the rules whose labels begin so" "seulement cette règle, ou celles dont le nom commence ainsi")))
        <*> optional (strOption (long "case" <> metavar "C" <> help (say "only this case" "seulement ce cas")))
    seconds = option positiveReal (long "timeout" <> metavar "S" <> value 10 <> help (say "seconds that the port may be silent (default: 10)" "secondes pendant lesquelles le portage peut se taire (par défaut\xA0: 10)"))
    positiveReal = eitherReader $ \text -> case real (Text.pack text) of
      Right x | x > 0 -> Right x
      _ -> Left (say "a number greater than 0" "un nombre supérieur à 0")
    suite = optional (strOption (long "suite" <> metavar (say "FOLDER" "DOSSIER") <> help (say "the folder of the suite (default: conformance here, or in the nearest folder around)" "le dossier de la suite (par défaut\xA0: conformance ici, ou dans le dossier le plus proche qui contient celui-ci)") <> action "directory"))

    original = switch (long "original" <> help (say "also tell what the original program does otherwise with a scene" "dire aussi ce que le programme d'origine fait autrement d'une scène"))

    scene = path "SCENE"
    path name = strArgument (metavar name <> action "file")
    format = option (eitherReader formatNamed) (long "format" <> metavar "text|json" <> value AsText <> help (say "how to print (default: text)" "comment afficher (par défaut\xA0: text)"))
    formatNamed name = case name of
      "text" -> Right AsText
      "json" -> Right AsJson
      _ -> Left (say "text or json" "text ou json")
    language = eitherReader (\name -> maybe (Left "en, fr") Right (lookup (Text.toLower (Text.pack name)) languageNames))
    atLeast least = eitherReader $ \text -> case integer (Text.pack text) of
      Right n | n >= least -> Right n
      _ -> Left (say "an integer, at least " "un entier, au moins " <> show (least :: Int))
